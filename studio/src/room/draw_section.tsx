// Values along a line from the window into the room, with their standard errors and the band of each row.

import { unsure, written } from "../draw/written";
import type { Along } from "./flat";
import { type Scale, share, ticks } from "./scale";

interface Props {
  line: Along;
  /** Distance of each sensor along the line [m]. */
  distances: number[];
  values: number[];
  errors: number[] | null;
  scale: Scale;
  unit: string;
  picked: number;
  isStale: boolean;
  axis: string;
  label: string;
  onPick: (sensor: number) => void;
}

const [WIDE, HIGH, LEFT, RIGHT, TOP, FOOT] = [640, 330, 58, 16, 16, 46];

export function DrawDepth({ line, distances, values, errors, scale, unit, picked, isStale, axis, label, onPick }: Props) {
  const places = line.band.map((one) => one.at);
  const [near, far] = [Math.min(0, ...places), Math.max(...places, 1)];
  const x = (at: number) => LEFT + ((at - near) / (far - near)) * (WIDE - LEFT - RIGHT);
  const y = (value: number) => HIGH - FOOT - share(scale, value) * (HIGH - FOOT - TOP);
  const path = (points: [number, number][]) => points.map(([px, py]) => `${px.toFixed(1)} ${py.toFixed(1)}`).join("L");
  const metres = ticks({ low: near, high: far, isLog: false }, 8);
  return (
    <svg class={`drawing${isStale ? " stale" : ""}`} viewBox={`0 0 ${WIDE} ${HIGH}`} role="img" aria-label={label}>
      {ticks(scale, 5).map((tick) => (
        <g key={tick}>
          <path class="hair" d={`M${LEFT} ${y(tick).toFixed(1)}H${WIDE - RIGHT}`} />
          <text class="small" x={LEFT - 7} y={y(tick)} text-anchor="end" dominant-baseline="central">
            {written(tick)}
          </text>
        </g>
      ))}
      <text class="small faint" x={LEFT + 6} y={TOP - 3}>
        {unit}
      </text>
      {metres.map((tick) => (
        <g key={tick}>
          <path class="measure" d={`M${x(tick).toFixed(1)} ${HIGH - FOOT}v5`} />
          <text class="small" x={x(tick)} y={HIGH - FOOT + 19} text-anchor="middle">
            {tick}
          </text>
        </g>
      ))}
      <path class="measure" d={`M${LEFT} ${HIGH - FOOT}H${WIDE - RIGHT}`} />
      <text class="small faint" x={(LEFT + WIDE - RIGHT) / 2} y={HIGH - 8} text-anchor="middle">
        {axis}
      </text>
      {line.band.length > 1 && <path class="rowBand" d={`M${path([...line.band.map((one): [number, number] => [x(one.at), y(one.most)]), ...[...line.band].reverse().map((one): [number, number] => [x(one.at), y(one.least)])])}Z`} />}
      <path class="curve rowLine" d={`M${path(line.sensors.map((k) => [x(distances[k]), y(values[k])]))}`} />
      {line.sensors.map((k) => {
        const [px, error] = [x(distances[k]), errors?.[k] ?? 0];
        const [up, down] = [y(values[k] + error), y(values[k] - error)];
        return (
          <g key={k}>
            {error > 0 && <path class="errorBar" d={`M${px} ${up}V${down}M${px - 4} ${up}h8M${px - 4} ${down}h8`} />}
            <circle class={`rowDot${k === picked ? " here" : ""}`} cx={px} cy={y(values[k])} r={k === picked ? 6 : 3.6} onClick={() => onPick(k)}>
              <title>{`${unsure(values[k], error).value}${error ? ` ± ${unsure(values[k], error).error}` : ""} ${unit}`}</title>
            </circle>
          </g>
        );
      })}
    </svg>
  );
}
