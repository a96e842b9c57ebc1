// Curves against one axis, several told apart by colour, dash and shape, with bands and errors.

import { useRef } from "preact/hooks";
import type { Numbers } from "../year/answers";
import { categoryOf, dashOf, markOf } from "./colours";
import { fit } from "./plans";
import { pointed } from "./pointed";
import { logTicks, ticks } from "./ticks";
import { written } from "./written";

export interface Line {
  label: string;
  values: Numbers;
  low?: Numbers;
  high?: Numbers;
  errors?: Numbers | null;
}
interface Props {
  x: number[];
  lines: Line[];
  label: string;
  xLabel: string;
  yLabel: string;
  unit: string;
  xUnit?: string;
  level?: number | null;
  isLogarithmic?: boolean;
  xTicks?: [number, string][];
  here?: number | null;
  low?: number;
  high?: number;
  width?: number;
  height?: number;
  shading?: [number, number][];
  onPick?: (k: number) => void;
}

const [LEFT, RIGHT, FOOT] = [58, 14, 44];

export function DrawLines({ x, lines, label, xLabel, yLabel, unit, level = null, isLogarithmic = false, xTicks, here = null, low, high, width = 520, height = 300, shading, onPick }: Props) {
  const drawing = useRef<SVGSVGElement>(null);
  const perRow = Math.max(1, Math.min(lines.length, Math.floor((width - LEFT - RIGHT) / (Math.min(Math.max(...lines.map((one) => one.label.length), 1), 30) * 6.6 + 44))));
  const top = 14 + 18 * Math.ceil(lines.length / perRow);
  const known = lines.flatMap((line) => [line.values, line.low ?? [], line.high ?? []].flat()).filter((one): one is number => one !== null && Number.isFinite(one));
  const positive = known.filter((one) => one > 0);
  const isLog = isLogarithmic && positive.length > 0;
  const least = isLog ? Math.min(...positive) / 1.15 : (low ?? Math.min(0, ...known));
  const most = isLog ? Math.max(...positive, level ?? 0) * 1.15 : (high ?? (Math.max(...known, level ?? -Infinity, least + 1e-9) - least) * 1.05 + least);
  const [first, last] = [Math.min(...x), Math.max(...x)];
  const px = (value: number) => LEFT + ((value - first) / (last - first || 1)) * (width - LEFT - RIGHT - 12) + 6;
  const py = (value: number) => {
    const share = isLog ? Math.log(Math.max(value, least) / least) / Math.log(most / least) : (value - least) / (most - least || 1);
    return height - FOOT - Math.min(Math.max(share, -0.02), 1.02) * (height - FOOT - top);
  };
  const path = (values: Numbers) => {
    let text = "";
    values.forEach((value, k) => {
      if (value === null) return;
      text += `${k === 0 || values[k - 1] === null ? "M" : "L"}${px(x[k]).toFixed(1)} ${py(value).toFixed(1)}`;
    });
    return text;
  };
  const band = (line: Line) => {
    if (!line.low || !line.high) return "";
    const there = x.map((_, k) => k).filter((k) => line.low?.[k] !== null && line.high?.[k] !== null);
    const point = (values: Numbers) => (k: number) => `${px(x[k]).toFixed(1)} ${py(values[k] as number).toFixed(1)}`;
    return there.length ? `M${there.map(point(line.low)).join("L")}L${[...there].reverse().map(point(line.high)).join("L")}Z` : "";
  };
  const pick = (event: MouseEvent) => {
    const at = pointed(drawing.current, event);
    if (!at || !onPick) return;
    let best = 0;
    x.forEach((value, k) => {
      if (Math.abs(px(value) - at.x) < Math.abs(px(x[best]) - at.x)) best = k;
    });
    onPick(best);
  };
  const few = x.length <= 40;
  return (
    <svg ref={drawing} class={`drawing${onPick ? " picks" : ""}`} style={{ maxWidth: `${width * 1.2}px`, margin: "auto" }} viewBox={`0 0 ${width} ${height}`} role="img" aria-label={label} onClick={onPick ? pick : undefined}>
      {shading?.map(([a, b]) => (
        <rect key={a} class="useSpan" x={px(a)} y={top} width={Math.max(px(b) - px(a), 0)} height={height - FOOT - top} />
      ))}
      {(isLog ? logTicks(least, most) : ticks(least, most, 5)).map((tick) => (
        <g key={tick}>
          <path class="hair" d={`M${LEFT} ${py(tick)}H${width - RIGHT}`} />
          <text class="small" x={LEFT - 7} y={py(tick)} text-anchor="end" dominant-baseline="central">
            {written(tick, unit === "%" && most > 10 ? "lx" : unit)}
          </text>
        </g>
      ))}
      {(xTicks ?? ticks(first, last, 7).map((tick): [number, string] => [tick, written(tick)])).map(([tick, text]) => (
        <text key={tick} class="small" x={px(tick)} y={height - FOOT + 17} text-anchor="middle">
          {text}
        </text>
      ))}
      <text class="small faint" x={(LEFT + width - RIGHT) / 2} y={height - 6} text-anchor="middle">
        {xLabel}
      </text>
      <text class="small faint" transform={`translate(13 ${(top + height - FOOT) / 2}) rotate(-90)`} text-anchor="middle">
        {fit(yLabel, height - FOOT - 10, 6)}
      </text>
      {level !== null && level > least && level < most && <path class="here" d={`M${LEFT} ${py(level)}H${width - RIGHT}`} />}
      {here !== null && <path class="here" d={`M${px(here)} ${top}V${height - FOOT}`} />}
      {lines.map((line, number) => (line.low ? <path key={`band${line.label}`} d={band(line)} fill={categoryOf(number)} fill-opacity={0.13} stroke="none" /> : null))}
      {lines.map((line, number) => (
        <g key={line.label}>
          <path class="curve" stroke={categoryOf(number)} stroke-dasharray={dashOf(number)} d={path(line.values)} />
          {line.errors?.map((error, k) => {
            const value = line.values[k];
            if (!error || value === null) return null;
            return <path key={k} stroke={categoryOf(number)} stroke-width={1} d={`M${px(x[k])} ${py(value - error)}V${py(value + error)}`} />;
          })}
          {few &&
            line.values.map((value, k) =>
              value === null ? null : (
                <path key={k} class="seriesMark" fill={categoryOf(number)} transform={`translate(${px(x[k]).toFixed(1)} ${py(value).toFixed(1)}) scale(0.7)`} d={markOf(number)}>
                  <title>{`${line.label}: ${written(value, unit)} ${unit}`}</title>
                </path>
              ),
            )}
        </g>
      ))}
      {lines.map((line, number) => {
        const each = (width - LEFT - RIGHT) / perRow;
        const [a, b] = [LEFT + (number % perRow) * each, 10 + 18 * Math.floor(number / perRow)];
        return (
          <g key={line.label} transform={`translate(${a} ${b})`}>
            <path class="curve" stroke={categoryOf(number)} stroke-dasharray={dashOf(number)} d="M0 0h24" />
            {few && <path class="seriesMark" fill={categoryOf(number)} transform="translate(12 0) scale(0.7)" d={markOf(number)} />}
            <text class="small" x={31} y={0} dominant-baseline="central">
              {fit(line.label, each - 34, 6.6)}
            </text>
          </g>
        );
      })}
    </svg>
  );
}
