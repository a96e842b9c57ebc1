// Plans side by side on one scale: cells, outline, windows, a contour, and one cursor for all.

import { useRef } from "preact/hooks";
import type { Point } from "../server/answers";
import type { Plan } from "../year/answers";
import { cividis, ofDifference } from "./colours";
import { contour, squaresOf } from "./contours";
import { pointed } from "./pointed";
import { logTicks, ticks } from "./ticks";
import { written } from "./written";

interface Props {
  plan: Plan;
  label: string;
  scaleLabel: string;
  windowWord: string;
  isDifference?: boolean;
  cursor: number;
  picked?: number;
  most?: number;
  onMove: (cell: number) => void;
  onPick?: (cell: number) => void;
}

const [LEFT, TOP, FOOT, GAP, BAR] = [38, 40, 38, 26, 92];
const MOST_NUMBERS = 90;

/** A number on a coloured cell, dark or light by what it lies on, with a rim that keeps it legible on any. */
function onCell(isLight: boolean) {
  const [fill, stroke] = isLight ? ["#10151b", "#ffffff"] : ["#ffffff", "#10151b"];
  return { fill, stroke, strokeWidth: 3, paintOrder: "stroke", strokeLinejoin: "round" } as const;
}

export function DrawPlans({ plan, label, scaleLabel, windowWord, isDifference, cursor, picked = -1, most = 1040, onMove, onPick }: Props) {
  const drawing = useRef<SVGSVGElement>(null);
  const { x, y } = plan;
  const step = [x, y].map((list) => (list.length > 1 ? (list[list.length - 1] - list[0]) / (list.length - 1) : 1));
  const half = step.map((one) => Math.abs(one) / 2);
  const window = plan.windows.flatMap((one) => one.points);
  const points = y.flatMap((b) => x.map((a): Point => [a, b]));
  const around = [...plan.outline, ...window, ...points.flatMap(([a, b]) => [[a - half[0], b - half[1]], [a + half[0], b + half[1]]])];
  const [lowX, highX] = [Math.min(...around.map((one) => one[0])), Math.max(...around.map((one) => one[0]))];
  const [lowY, highY] = [Math.min(...around.map((one) => one[1])), Math.max(...around.map((one) => one[1]))];
  const count = plan.variants.length;
  const room = (most - BAR) / Math.min(count, 4) - LEFT - GAP;
  const scale = Math.min(360 / (highY - lowY), Math.max(room, 84) / (highX - lowX));
  const [wide, high] = [(highX - lowX) * scale, (highY - lowY) * scale];
  const each = Math.max(LEFT + wide + GAP, count === 1 ? 320 : most < 700 ? 172 : 186);
  const columns = Math.max(1, Math.min(count, Math.floor((most - BAR) / each)));
  const rows = Math.ceil(count / columns);
  const [whole, tall] = [columns * each + BAR, rows * (TOP + high + FOOT)];
  const share = (value: number) => {
    if (plan.is_logarithmic) return Math.log(Math.max(value, plan.low) / plan.low) / Math.log(plan.high / plan.low);
    return (value - plan.low) / (plan.high - plan.low);
  };
  const colour = isDifference ? ofDifference : cividis;
  const origin = (number: number) => [(number % columns) * each + LEFT, Math.floor(number / columns) * (TOP + high + FOOT) + TOP];
  const at = (a: number, b: number) => `${((a - lowX) * scale).toFixed(1)} ${((highY - b) * scale).toFixed(1)}`;
  const squares = squaresOf(x.length, y.length);
  const cellAt = (event: MouseEvent): number => {
    const point = pointed(drawing.current, event);
    if (!point) return -1;
    for (let number = 0; number < count; number++) {
      const [ox, oy] = origin(number);
      const [a, b] = [lowX + (point.x - ox) / scale, highY - (point.y - oy) / scale];
      const column = Math.floor((a - x[0]) / step[0] + 0.5);
      const row = Math.floor((b - y[0]) / step[1] + 0.5);
      if (column >= 0 && column < x.length && row >= 0 && row < y.length && plan.sensors[row * x.length + column] !== null) return row * x.length + column;
    }
    return -1;
  };
  const key = (event: KeyboardEvent) => {
    const way = ({ ArrowUp: [0, 1], ArrowDown: [0, -1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] } as Record<string, number[]>)[event.key];
    if (event.key === "Enter" || event.key === " ") {
      event.preventDefault();
      if (cursor >= 0) onPick?.(cursor);
    }
    if (!way) return;
    event.preventDefault();
    const start = cursor >= 0 ? cursor : Math.max(picked, 0);
    const column = (start % x.length) + way[0];
    const row = Math.floor(start / x.length) + way[1] * Math.sign(step[1] || 1);
    const to = row * x.length + column;
    if (cursor < 0) onMove(start);
    else if (column >= 0 && column < x.length && row >= 0 && row < y.length && plan.sensors[to] !== null) onMove(to);
  };
  const square = (cell: number, name: string, number: number) => {
    const [a, b] = [x[cell % x.length], y[Math.floor(cell / x.length)]];
    return <path key={`${name}${number}`} class={name} d={`M${at(a - half[0], b - half[1])}L${at(a + half[0], b - half[1])}L${at(a + half[0], b + half[1])}L${at(a - half[0], b + half[1])}Z`} />;
  };
  const bar = isDifference || !plan.is_logarithmic ? ticks(plan.low, plan.high, 5) : logTicks(plan.low, plan.high);
  const [barX, barHigh] = [columns * each + 12, Math.min(high, 260)];
  const numbers = x.length * y.length <= MOST_NUMBERS && Math.min(step[0], step[1]) * scale > 24;
  return (
    <svg
      ref={drawing}
      class={`drawing plans${onPick ? " picks" : ""}`}
      style={{ maxWidth: `${whole * 1.25}px` }}
      viewBox={`0 0 ${whole.toFixed(0)} ${tall.toFixed(0)}`}
      role="application"
      aria-label={label}
      tabindex={0}
      onMouseMove={(event) => onMove(cellAt(event))}
      onMouseLeave={() => onMove(-1)}
      onBlur={() => onMove(-1)}
      onClick={(event) => {
        const cell = cellAt(event);
        if (cell >= 0) onPick?.(cell);
      }}
      onKeyDown={key}
    >
      {plan.variants.map((variant, number) => {
        const [ox, oy] = origin(number);
        const line = plan.level === null ? "" : contour(squares, points, variant.values, plan.level).map((piece) => `M${piece.map(([a, b]) => at(a, b)).join("L")}`).join("");
        return (
          <g key={variant.label} transform={`translate(${ox.toFixed(1)} ${oy.toFixed(1)})`}>
            <text class="planTitle" x={0} y={-24}>
              {fit(variant.label, each - 20)}
              <title>{variant.label}</title>
            </text>
            <text class="small faint" x={0} y={-9}>
              {written(variant.least, plan.unit)} … {written(variant.mean, plan.unit)} … {written(variant.most, plan.unit)} {plan.unit}
            </text>
            {variant.values.map((value, cell) => {
              if (value === null) return null;
              const [a, b] = [x[cell % x.length], y[Math.floor(cell / x.length)]];
              const fill = colour(share(value));
              return <rect key={cell} x={(a - half[0] - lowX) * scale} y={(highY - b - half[1]) * scale} width={2 * half[0] * scale} height={2 * half[1] * scale} fill={fill} stroke={fill} stroke-width={0.4} />;
            })}
            {plan.outline.length > 2 && <path class="planOutline" d={`M${plan.outline.map(([a, b]) => at(a, b)).join("L")}Z`} />}
            {plan.windows.map((one) => (
              <path key={one.name} class="planWindow" d={`M${one.points.map(([a, b]) => at(a, b)).join("L")}Z`}>
                <title>{`${windowWord}: ${one.name}`}</title>
              </path>
            ))}
            {line && <path class="planContourBack" d={line} />}
            {line && <path class="planContour" d={line} />}
            {numbers &&
              variant.values.map((value, cell) =>
                value === null ? null : (
                  <text key={cell} class="cellNumber" style={onCell(isDifference || share(value) > 0.55)} x={(x[cell % x.length] - lowX) * scale} y={(highY - y[Math.floor(cell / x.length)]) * scale} text-anchor="middle" dominant-baseline="central">
                    {written(value, Math.abs(value) >= 10 ? "lx" : plan.unit)}
                  </text>
                ),
              )}
            {picked >= 0 && square(picked, "pickedCell", number)}
            {cursor >= 0 && square(cursor, "cursorCell", number)}
            {ticks(0, highX, wide > 150 ? 4 : 2).map((tick) => (
              <text key={tick} class="small faint" x={(tick - lowX) * scale} y={high + 14} text-anchor="middle">
                {tick}
              </text>
            ))}
            {number % columns === 0 &&
              ticks(0, highY, 5).map((tick) => (
                <text key={tick} class="small faint" x={-8} y={(highY - tick) * scale} text-anchor="end" dominant-baseline="central">
                  {tick}
                </text>
              ))}
            <text class="small faint" x={wide / 2} y={high + 29} text-anchor="middle">
              m
            </text>
          </g>
        );
      })}
      <g transform={`translate(${barX} ${TOP})`}>
        {Array.from({ length: 64 }, (_, k) => (
          <rect key={k} x={0} y={barHigh * (1 - (k + 1) / 64)} width={14} height={barHigh / 64 + 0.6} fill={colour((k + 0.5) / 64)} />
        ))}
        {bar.map((tick) => (
          <text key={tick} class="small" x={20} y={barHigh * (1 - share(tick))} dominant-baseline="central">
            {written(tick, plan.unit === "%" && plan.high > 10 ? "lx" : plan.unit)}
          </text>
        ))}
        {plan.level !== null && plan.level > plan.low && plan.level < plan.high && (
          <g>
            <path class="planContourBack" d={`M-3 ${barHigh * (1 - share(plan.level))}h20`} />
            <path class="planContour" d={`M-3 ${barHigh * (1 - share(plan.level))}h20`} />
          </g>
        )}
        <text class="small faint" x={0} y={-12}>
          {scaleLabel}
        </text>
      </g>
    </svg>
  );
}

/** A label that fits a width, with an ellipsis if it does not. */
export function fit(text: string, width: number, each = 7.2): string {
  const most = Math.floor(width / each);
  return text.length > most ? `${text.slice(0, Math.max(most - 1, 1)).trimEnd()}…` : text;
}
