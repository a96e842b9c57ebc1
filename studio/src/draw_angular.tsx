// Shares against elevation, as a curve and as a radial diagram.

import type { Table } from "./answers";
import { HUES } from "./colours";

export interface Curve {
  name: string;
  table: Table;
  dash: string;
}

interface Props {
  curves: Curve[];
  quantities: string[];
  elevation: number;
  words: Record<string, string>;
  label: string;
}

const [WIDE, HIGH, LEFT, FOOT] = [560, 300, 44, 40];

export function DrawAngular({ curves, quantities, elevation, words, label, axis }: Props & { axis: string }) {
  const x = (deg: number) => LEFT + ((deg + 90) / 180) * (WIDE - LEFT - 10);
  const y = (share: number) => HIGH - FOOT - share * (HIGH - FOOT - 12);
  return (
    <svg class="drawing" viewBox={`0 0 ${WIDE} ${HIGH}`} role="img" aria-label={label}>
      {[0, 0.25, 0.5, 0.75, 1].map((share) => (
        <g key={share}>
          <path class="hair" d={`M${LEFT} ${y(share)}H${WIDE - 10}`} />
          <text class="small" x={LEFT - 6} y={y(share)} text-anchor="end" dominant-baseline="central">
            {100 * share}
          </text>
        </g>
      ))}
      {[-90, -60, -30, 0, 30, 60, 90].map((deg) => (
        <text key={deg} class="small" x={x(deg)} y={HIGH - FOOT + 15} text-anchor="middle">
          {deg}°
        </text>
      ))}
      <text class="small faint" x={WIDE / 2} y={HIGH - 4} text-anchor="middle">
        {axis}
      </text>
      <text class="small faint" x={4} y={12}>
        %
      </text>
      {curves.flatMap((curve) =>
        quantities.map((name) => (
          <path
            key={curve.name + name}
            class="curve"
            stroke={HUES[name]}
            stroke-dasharray={curve.dash}
            d={`M${curve.table.elevation_deg.map((deg, k) => `${x(deg).toFixed(1)} ${y(curve.table[name][k]).toFixed(1)}`).join("L")}`}
          />
        )),
      )}
      <path class="here" d={`M${x(elevation)} ${y(0)}V${y(1)}`} />
      {curves.flatMap((curve) =>
        quantities.map((name) => {
          const value = at(curve.table, name, elevation);
          return value === null ? null : <circle key={curve.name + name} class="dot" cx={x(elevation)} cy={y(value)} r={4.5} fill={HUES[name]} />;
        }),
      )}
      {quantities.map((name, k) => (
        <g key={name}>
          <path class="curve" stroke={HUES[name]} d={`M${LEFT + 10 + k * 150} ${22}h18`} />
          <text class="small halo-text" x={LEFT + 34 + k * 150} y={22} dominant-baseline="central">
            {words[name]}
          </text>
        </g>
      ))}
    </svg>
  );
}

/** Light comes from the left, as in the section: the radius is the share, the direction where it comes from. */
export function DrawRadial({ curves, quantities, elevation, words, label }: Props) {
  const [size, radius] = [320, 136];
  const [cx, cy] = [size * 0.7, size / 2];
  const point = (deg: number, share: number) => {
    const e = (deg * Math.PI) / 180;
    return `${(cx - radius * share * Math.cos(e)).toFixed(1)} ${(cy - radius * share * Math.sin(e)).toFixed(1)}`;
  };
  const round = (share: number) => `M${Array.from({ length: 61 }, (_, k) => point(-90 + 3 * k, share)).join("L")}`;
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
        <text key={share} class="small faint" x={cx + 6} y={cy - radius * share} dominant-baseline="central">
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
        <g key={name}>
          <path class="curve" stroke={HUES[name]} d={`M10 ${16 + 18 * k}h16`} />
          <text class="small" x={32} y={16 + 18 * k} dominant-baseline="central">
            {words[name]}
          </text>
        </g>
      ))}
    </svg>
  );
}

function at(table: Table, name: string, deg: number): number | null {
  const xs = table.elevation_deg;
  const k = xs.findIndex((one) => one >= deg);
  if (k < 0 || (k === 0 && xs[0] > deg)) return null;
  if (xs[k] === deg || k === 0) return table[name][k];
  const share = (deg - xs[k - 1]) / (xs[k] - xs[k - 1]);
  return table[name][k - 1] * (1 - share) + table[name][k] * share;
}
