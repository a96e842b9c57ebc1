// A cut through the light that a BSDF sends out: outside on the left, room on the right, logarithmic.

import type { Cut } from "../server/answers";
import { LineKey } from "./axes";
import { OF_BLOCK } from "./colours";

const DECADES = 4;

export function DrawCut({ cut, isFront, isLogarithmic, outside, room, unit, label }: { cut: Cut; isFront: boolean; isLogarithmic: boolean; outside: string; room: string; unit: string; label: string }) {
  const [size, radius] = [420, 165];
  const centre = size / 2;
  const most = Math.max(...cut.curves.flatMap((curve) => curve.values), 1e-9);
  const outer = Math.ceil(Math.log10(most) * 2) / 2;
  const whole = rounded(most);
  const point = (deg: number, far: number, isRoom: boolean) => {
    const e = (deg * Math.PI) / 180;
    return `${(centre + (isRoom ? 1 : -1) * radius * far * Math.cos(e)).toFixed(1)} ${(centre - radius * far * Math.sin(e)).toFixed(1)}`;
  };
  const far = (value: number) => (isLogarithmic ? Math.max(0, 1 + (Math.log10(Math.max(value, 1e-30)) - outer) / DECADES) : value / whole);
  return (
    <svg class="drawing cut" viewBox={`0 0 ${size} ${size}`} role="img" aria-label={label}>
      {[1, 2, 3, 4].map((k) => (
        <g key={k}>
          <circle class="ringLine" cx={centre} cy={centre} r={(radius * k) / DECADES} />
          <text class="small faint" x={centre + 4} y={centre - (radius * k) / DECADES - 4}>
            {Number((isLogarithmic ? 10 ** (outer - DECADES + k) : (whole * k) / DECADES).toPrecision(2))}
          </text>
        </g>
      ))}
      {[-60, -30, 0, 30, 60].map((deg) => (
        <path key={deg} class="hair" d={`M${point(deg, 1, false)}L${point(-deg, 1, true)}`} />
      ))}
      <path class="film" d={`M${centre} ${centre - radius}V${centre + radius}`} />
      {cut.curves.map((curve) => {
        const isRoom = isFront === (curve.word === "Transmitted");
        const points = curve.values.map((value, k) => point(cut.angle_deg[k], far(value), isRoom)).join("L");
        return <path key={curve.word} d={`M${centre} ${centre}L${points}Z`} fill={OF_BLOCK[curve.word]} fill-opacity={0.2} stroke={OF_BLOCK[curve.word]} stroke-width={1.6} />;
      })}
      <path class="arrow" d={`M${point(cut.from_deg, 1.08, !isFront)}L${point(cut.from_deg, 0.06, !isFront)}`} />
      <text class="small" x={20} y={size - 10}>
        {outside}
      </text>
      <text class="small" x={size - 20} y={size - 10} text-anchor="end">
        {room}
      </text>
      <text class="small faint" x={centre} y={size - 10} text-anchor="middle">
        BSDF [{unit}]
      </text>
      {cut.curves.map((curve, k) => (
        <LineKey key={curve.word} x={10} y={16 + 18 * k} length={16} stroke={OF_BLOCK[curve.word]} text={curve.word} />
      ))}
    </svg>
  );
}

/** A round number that is no less. */
function rounded(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * ([1, 2, 4, 8, 10].find((step) => step * power >= value) ?? 10);
}
