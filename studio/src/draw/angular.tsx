// Shares against elevation, of one panel or of two on one pair of axes.

import type { Table } from "../server/answers";
import { type Axes, axesOf, Here, LineKey, lineOf, ShareAxes } from "./axes";
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

export function DrawAngular({ curves, quantities, elevation, words, label, axis, names }: CurveProps & { axis: string; names: Record<string, string> }) {
  const axes = axesOf(330);
  const { wide, high, left, x, y } = axes;
  const across = (wide - left) / quantities.length;
  return (
    <svg class="drawing" viewBox={`0 0 ${wide} ${high}`} role="img" aria-label={label}>
      <ShareAxes axes={axes} axis={axis} />
      {curves.flatMap((curve) =>
        quantities.map((name) => (
          <g key={curve.name + name}>
            <Band table={curve.table} name={name} axes={axes} />
            <path class="curve" stroke={HUES[name]} stroke-dasharray={curve.dash} d={lineOf(axes, curve.table.elevation_deg, curve.table[name])} />
          </g>
        )),
      )}
      <Here axes={axes} elevation={elevation} />
      {curves.flatMap((curve) =>
        quantities.map((name) => {
          const value = at(curve.table, name, elevation);
          return value === null ? null : <circle key={curve.name + name} class="dot" cx={x(elevation)} cy={y(value)} r={4.5} fill={HUES[name]} />;
        }),
      )}
      {quantities.map((name, k) => (
        <LineKey key={name} x={left + k * across} y={12} stroke={HUES[name]} text={words[name]} />
      ))}
      {curves.length > 1 && curves.map((curve, k) => <LineKey key={curve.name} x={wide - 190 + k * 96} y={30} length={24} dash={curve.dash} text={names[curve.name]} />)}
    </svg>
  );
}

/** Two standard errors on either side, if there are any. */
function Band({ table, name, axes }: { table: Table; name: string; axes: Axes }) {
  const errors = table[`${name}_standard_error`];
  if (!errors) return null;
  const edge = (sign: number) => lineOf(axes, table.elevation_deg, table[name].map((share, k) => Math.max(0, share + 2 * sign * errors[k]))).slice(1).split("L");
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
