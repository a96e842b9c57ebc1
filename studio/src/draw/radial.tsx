// Radial diagrams: shares by where the light comes from, and where the light of one incidence goes.

import type { Lobe, Walked } from "../server/answers";
import type { CurveProps } from "./angular";
import { LineKey } from "./axes";
import { HUES } from "./colours";

const RAD = Math.PI / 180;

/** Light comes from the left, as in the section, on the back from the right: the radius is the share. */
export function DrawRadial({ curves, quantities, elevation, words, label, side, names }: CurveProps & { side: string; names: Record<string, string> }) {
  const [size, radius] = [320, 136];
  const way = side === "back" ? -1 : 1;
  const [cx, cy] = [size / 2 + way * size * 0.2, size / 2];
  const point = (deg: number, share: number) => `${(cx - way * radius * share * Math.cos(deg * RAD)).toFixed(1)} ${(cy - radius * share * Math.sin(deg * RAD)).toFixed(1)}`;
  const round = (share: number) => `M${Array.from({ length: 61 }, (_, k) => point(-90 + 3 * k, share)).join("L")}`;
  const left = way > 0 ? 6 : 178;
  return (
    <svg class="drawing radial" viewBox={`0 0 ${size} ${size}`} role="img" aria-label={label}>
      {[0.25, 0.5, 0.75, 1].map((share) => (
        <path key={share} class="hair" d={round(share)} />
      ))}
      {[-60, -30, 0, 30, 60].map((deg) => (
        <g key={deg}>
          <path class="hair" d={`M${point(deg, 0)}L${point(deg, 1)}`} />
          <text class="small faint" x={point(deg, 1.1).split(" ")[0]} y={point(deg, 1.1).split(" ")[1]} text-anchor="middle" dominant-baseline="central">
            {deg}°
          </text>
        </g>
      ))}
      <path class="hair" d={`M${cx} ${cy - radius}V${cy + radius}`} />
      {[0.5, 1].map((share) => (
        <text key={share} class="small faint" x={cx + way * 6} y={cy - radius * share} text-anchor={way > 0 ? "start" : "end"} dominant-baseline="central">
          {100 * share} %
        </text>
      ))}
      {curves.flatMap((curve) =>
        quantities.map((name) => (
          <path key={curve.name + name} class="curve" stroke={HUES[name]} stroke-dasharray={curve.dash} d={`M${curve.table.elevation_deg.map((deg, k) => point(deg, curve.table[name][k])).join("L")}`} />
        )),
      )}
      <path class="here" d={`M${point(elevation, 0)}L${point(elevation, 1.04)}`} />
      {quantities.map((name, k) => (
        <LineKey key={name} x={left} y={14 + 18 * k} length={16} stroke={HUES[name]} text={words[name]} />
      ))}
      {curves.length > 1 && curves.map((curve, k) => <LineKey key={curve.name} x={left} y={size - 24 + 18 * k} length={16} dash={curve.dash} text={names[curve.name]} />)}
    </svg>
  );
}

interface GoesProps {
  lobes: Lobe[];
  spread: Walked["distribution"] | null;
  elevation: number;
  side: string;
  label: string;
  words: Record<string, string>;
  outside: string;
  room: string;
}

/** Outside on the left, the room on the right: beams as spokes, rough panels as petals; length by the root of the share. */
export function DrawGoes({ lobes, spread, elevation, side, label, words, outside, room }: GoesProps) {
  const [size, radius] = [320, 132];
  const c = size / 2;
  const end = (deg: number, far: number, isRoom: boolean): string => `${(c + (isRoom ? 1 : -1) * far * Math.cos(deg * RAD)).toFixed(1)} ${(c - far * Math.sin(deg * RAD)).toFixed(1)}`;
  const hue = (isRoom: boolean, deg: number): string => (isRoom === (side === "back") ? HUES.reflectance : deg * -elevation < 0 ? HUES.transmittance_deflected : HUES.transmittance_undeflected);
  const most = Math.max(...(spread ? [...spread.front, ...spread.back] : [1]), 1e-9);
  const far = (share: number) => radius * Math.sqrt(Math.min(1, spread ? share / most : share));
  const rings = spread ? [0.25, 0.5, 1].map((part) => [part * most, `${(100 * part * most).toPrecision(2)} %`] as const) : ([[0.05, "5 %"], [0.25, "25 %"], [1, "100 %"]] as const);
  const kinds = ["transmittance_deflected", "transmittance_undeflected", "reflectance"];
  return (
    <svg class="drawing radial" viewBox={`0 0 ${size} ${size + 20}`} role="img" aria-label={label}>
      {rings.map(([share, text]) => (
        <g key={text}>
          <circle class="ringLine" cx={c} cy={c} r={far(share)} />
          <text class="small faint" x={c + 3} y={c - far(share) + 4} dominant-baseline="hanging">
            {text}
          </text>
        </g>
      ))}
      {[-60, -30, 0, 30, 60].map((deg) => (
        <path key={deg} class="hair" d={`M${end(deg, radius, false)}L${end(-deg, radius, true)}`} />
      ))}
      <path class="film" d={`M${c} ${c - radius}V${c + radius}`} />
      {spread &&
        [false, true].flatMap((isRoom) =>
          (isRoom ? spread.back : spread.front).map((share, k) => {
            const [low, high] = [spread.edges_deg[k], spread.edges_deg[k + 1]];
            return share > 0 ? <path key={`${isRoom}${k}`} d={`M${c} ${c}L${end(low, far(share), isRoom)}L${end(high, far(share), isRoom)}Z`} fill={hue(isRoom, low + high)} fill-opacity={0.85} /> : null;
          }),
        )}
      {!spread &&
        lobes
          .filter((lobe) => lobe.power >= 2e-4)
          .map((lobe, k) => {
            const isRoom = lobe.side === "back";
            return <path key={k} d={`M${c} ${c}L${end(lobe.elevation_deg, far(lobe.power), isRoom)}`} stroke={hue(isRoom, lobe.elevation_deg)} stroke-width={lobe.power > 0.02 ? 4 : 1.5} stroke-linecap="round" />;
          })}
      <path class="arrow" d={`M${end(elevation, radius + 12, side === "back")}L${end(elevation, radius - 14, side === "back")}`} />
      <text class="small faint" x={4} y={12}>
        {outside}
      </text>
      <text class="small faint" x={size - 4} y={12} text-anchor="end">
        {room}
      </text>
      {kinds.map((name, k) => (
        <LineKey key={name} x={2 + k * 112} y={size + 12} length={14} stroke={HUES[name]} text={words[name]} />
      ))}
    </svg>
  );
}
