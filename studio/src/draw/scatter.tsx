// Cases as marks: one figure against another or against a parameter, in series, with a front.

import { categoryOf, dashOf, markOf } from "./colours";
import { fit } from "./plans";
import { ticks } from "./ticks";
import { written } from "./written";

export interface Mark {
  x: number;
  y: number;
  error?: number | null;
  row: number;
}
export interface Series {
  label: string;
  marks: Mark[];
  isJoined: boolean;
}
interface Props {
  series: Series[];
  words?: [number, string][];
  label: string;
  xLabel: string;
  yLabel: string;
  front?: number[];
  frontWord: string;
  best?: number | null;
  bestWord: string;
  cursor: number;
  onMove: (row: number) => void;
}

const [WIDE, HIGH, LEFT, RIGHT, FOOT] = [880, 440, 66, 18, 48];

export function DrawScatter({ series, words, label, xLabel, yLabel, front = [], frontWord, best = null, bestWord, cursor, onMove }: Props) {
  const every = series.flatMap((one) => one.marks);
  const legend = [...series.map((one) => one.label), ...(front.length > 1 ? [frontWord] : []), ...(best !== null ? [bestWord] : [])];
  const perRow = legend.some((one) => one.length > 22) ? 3 : 4;
  const shows = series.length > 1 || front.length > 1 || best !== null;
  const top = shows ? 14 + 20 * Math.ceil(legend.length / perRow) : 14;
  const ends = (values: number[]) => {
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const pad = (high - low || Math.abs(high) || 1) * 0.06;
    return [low - pad, high + pad];
  };
  const [lowX, highX] = ends(every.map((one) => one.x));
  const [lowY, highY] = ends(every.flatMap((one) => [one.y - (one.error ?? 0), one.y + (one.error ?? 0)]));
  const px = (value: number) => LEFT + ((value - lowX) / (highX - lowX)) * (WIDE - LEFT - RIGHT);
  const py = (value: number) => HIGH - FOOT - ((value - lowY) / (highY - lowY)) * (HIGH - FOOT - top);
  const byRow = new Map(every.map((one) => [one.row, one]));
  const rows = every.map((one) => one.row);
  const key = (event: KeyboardEvent) => {
    const way = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (!way || !rows.length) return;
    event.preventDefault();
    onMove(rows[(rows.indexOf(cursor) + way + rows.length) % rows.length]);
  };
  const at = byRow.get(cursor);
  return (
    <svg class="drawing" style={{ maxWidth: `${WIDE * 1.15}px`, margin: "auto" }} viewBox={`0 0 ${WIDE} ${HIGH}`} role="application" aria-label={label} tabindex={0} onKeyDown={key} onMouseLeave={() => onMove(-1)}>
      {ticks(lowY, highY, 6).map((tick) => (
        <g key={tick}>
          <path class="hair" d={`M${LEFT} ${py(tick)}H${WIDE - RIGHT}`} />
          <text class="small" x={LEFT - 7} y={py(tick)} text-anchor="end" dominant-baseline="central">
            {written(tick)}
          </text>
        </g>
      ))}
      {(words ?? ticks(lowX, highX, 8).map((tick): [number, string] => [tick, written(tick)])).map(([tick, text]) => (
        <g key={tick}>
          <path class="hair" d={`M${px(tick)} ${top}V${HIGH - FOOT}`} />
          <text class="small" x={px(tick)} y={HIGH - FOOT + 17} text-anchor="middle">
            {words ? fit(text, (WIDE - LEFT) / words.length, 6.8) : text}
          </text>
        </g>
      ))}
      <text class="small faint" x={(LEFT + WIDE - RIGHT) / 2} y={HIGH - 8} text-anchor="middle">
        {fit(xLabel, WIDE - LEFT, 6.4)}
      </text>
      <text class="small faint" transform={`translate(14 ${(top + HIGH - FOOT) / 2}) rotate(-90)`} text-anchor="middle">
        {fit(yLabel, HIGH - FOOT - top, 6.4)}
      </text>
      {front.length > 1 && (
        <path
          class="frontLine"
          d={`M${front
            .map((row) => byRow.get(row))
            .filter((one): one is Mark => one !== undefined)
            .map((one) => `${px(one.x).toFixed(1)} ${py(one.y).toFixed(1)}`)
            .join("L")}`}
        />
      )}
      {series.map((one, number) => (
        <g key={one.label}>
          {one.isJoined && (
            <path
              class="curve"
              stroke={categoryOf(number)}
              stroke-dasharray={dashOf(number)}
              d={`M${[...one.marks]
                .sort((a, b) => a.x - b.x)
                .map((mark) => `${px(mark.x).toFixed(1)} ${py(mark.y).toFixed(1)}`)
                .join("L")}`}
            />
          )}
          {one.marks.map((mark) => (
            <g key={mark.row} transform={`translate(${px(mark.x).toFixed(1)} ${py(mark.y).toFixed(1)})`} onMouseEnter={() => onMove(mark.row)}>
              {mark.error ? <path stroke={categoryOf(number)} stroke-width={1.3} d={`M0 ${(py(mark.y - mark.error) - py(mark.y)).toFixed(1)}V${(py(mark.y + mark.error) - py(mark.y)).toFixed(1)}`} /> : null}
              <circle r={11} fill="transparent" />
              <path class={`seriesMark${front.length > 1 && !front.includes(mark.row) ? " beaten" : ""}`} data-row={mark.row} fill={categoryOf(number)} d={markOf(number)} />
            </g>
          ))}
        </g>
      ))}
      {best !== null && byRow.get(best) && <circle class="bestRing" cx={px((byRow.get(best) as Mark).x)} cy={py((byRow.get(best) as Mark).y)} r={11} />}
      {at && <path class="cross" d={`M${px(at.x)} ${top}V${HIGH - FOOT}M${LEFT} ${py(at.y)}H${WIDE - RIGHT}`} />}
      {shows &&
        legend.map((name, number) => {
          const width = (WIDE - LEFT - RIGHT) / perRow;
          const isSeries = number < series.length;
          return (
            <g key={name} transform={`translate(${LEFT + (number % perRow) * width + 6} ${12 + 20 * Math.floor(number / perRow)})`}>
              {isSeries ? <path class="seriesMark" fill={categoryOf(number)} d={markOf(number)} /> : name === frontWord ? <path class="frontLine" d="M-6 0h14" /> : <circle class="bestRing" r={6} />}
              <text class="small" x={14} y={0} dominant-baseline="central">
                {fit(name, width - 22, 6.6)}
              </text>
            </g>
          );
        })}
    </svg>
  );
}
