// Shares against elevation, of one panel or of two on one pair of axes.

import type { Table } from "./answers";
import { HUES } from "./colours";

export interface Curve {
  name: string;
  table: Table;
  dash: string;
}

export interface CurveProps {
  curves: Curve[];
  quantities: string[];
  elevation: number;
  words: Record<string, string>;
  label: string;
}

const [WIDE, HIGH, LEFT, FOOT, HEAD] = [560, 330, 44, 40, 44];

export function DrawAngular({ curves, quantities, elevation, words, label, axis, names }: CurveProps & { axis: string; names: Record<string, string> }) {
  const x = (deg: number) => LEFT + ((deg + 90) / 180) * (WIDE - LEFT - 14);
  const y = (share: number) => HIGH - FOOT - share * (HIGH - FOOT - HEAD);
  const across = (WIDE - LEFT) / quantities.length;
  return (
    <svg class="drawing" viewBox={`0 0 ${WIDE} ${HIGH}`} role="img" aria-label={label}>
      {[0, 0.25, 0.5, 0.75, 1].map((share) => (
        <g key={share}>
          <path class="hair" d={`M${LEFT} ${y(share)}H${WIDE - 14}`} />
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
      <text class="small faint" x={(WIDE + LEFT) / 2} y={HIGH - 6} text-anchor="middle">
        {axis}
      </text>
      <text class="small faint" x={LEFT - 6} y={HEAD - 14} text-anchor="end">
        %
      </text>
      {curves.flatMap((curve) =>
        quantities.map((name) => (
          <g key={curve.name + name}>
            {band(curve.table, name, x, y)}
            <path class="curve" stroke={HUES[name]} stroke-dasharray={curve.dash} d={`M${curve.table.elevation_deg.map((deg, k) => `${x(deg).toFixed(1)} ${y(curve.table[name][k]).toFixed(1)}`).join("L")}`} />
          </g>
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
          <path class="curve" stroke={HUES[name]} d={`M${LEFT + k * across} ${12}h18`} />
          <text class="small" x={LEFT + 24 + k * across} y={12} dominant-baseline="central">
            {words[name]}
          </text>
        </g>
      ))}
      {curves.length > 1 &&
        curves.map((curve, k) => (
          <g key={curve.name}>
            <path class="curve" stroke="currentColor" stroke-dasharray={curve.dash} d={`M${WIDE - 190 + k * 96} ${30}h24`} />
            <text class="small" x={WIDE - 160 + k * 96} y={30} dominant-baseline="central">
              {names[curve.name]}
            </text>
          </g>
        ))}
    </svg>
  );
}

/** Two standard errors on either side, if there are any. */
function band(table: Table, name: string, x: (deg: number) => number, y: (share: number) => number) {
  const errors = table[`${name}_standard_error`];
  if (!errors) return null;
  const edge = (sign: number) => table.elevation_deg.map((deg, k) => `${x(deg).toFixed(1)} ${y(Math.max(0, table[name][k] + 2 * sign * errors[k])).toFixed(1)}`);
  return <path d={`M${[...edge(1), ...edge(-1).reverse()].join("L")}Z`} fill={HUES[name]} fill-opacity={0.25} />;
}

export function at(table: Table, name: string, deg: number): number | null {
  const xs = table.elevation_deg;
  const k = xs.findIndex((one) => one >= deg);
  if (k < 0 || (k === 0 && xs[0] > deg)) return null;
  if (xs[k] === deg || k === 0) return table[name][k];
  const share = (deg - xs[k - 1]) / (xs[k] - xs[k - 1]);
  return table[name][k - 1] * (1 - share) + table[name][k] * share;
}
