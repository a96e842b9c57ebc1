// Carpets of a year: days across, hours up, one below the other on one scale.

import { useMemo, useRef } from "preact/hooks";
import type { Carpet, Numbers } from "../year/answers";
import { cividis } from "./colours";
import { pointed } from "./pointed";
import { written } from "./written";

interface Props {
  carpet: Carpet;
  label: string;
  months: string[];
  hourWord: string;
  onlyUse: boolean;
  isDark: boolean;
  cursor: [number, number] | null;
  picked: [number, number] | null;
  onMove: (cell: [number, number] | null) => void;
  onPick: (cell: [number, number]) => void;
}

const [WIDE, EACH, LEFT, TOP, GAP, FOOT, RIGHT] = [1000, 128, 40, 22, 16, 26, 74];
/** Pixels of the picture for each cell, so that cells stay sharp when they are enlarged. */
const [ACROSS, UP] = [4, 10];
const NIGHT = "#0a0c10";

export function DrawCarpet({ carpet, label, months, hourWord, onlyUse, isDark, cursor, picked, onMove, onPick }: Props) {
  const drawing = useRef<SVGSVGElement>(null);
  const days = carpet.days.length;
  const inner = WIDE - LEFT - RIGHT;
  const block = TOP + EACH + GAP;
  const tall = carpet.variants.length * block + FOOT;
  const pictures = useMemo(() => carpet.variants.map((one) => painted(carpet, one.values, onlyUse, isDark)), [carpet, onlyUse, isDark]);
  const x = (day: number) => LEFT + (day / days) * inner;
  const y = (number: number, hour: number) => number * block + TOP + EACH * (1 - hour / 24);
  const cellAt = (event: MouseEvent): [number, number] | null => {
    const point = pointed(drawing.current, event);
    if (!point) return null;
    const day = Math.floor(((point.x - LEFT) / inner) * days);
    const number = Math.floor(point.y / block);
    const hour = 24 * (1 - (point.y - number * block - TOP) / EACH);
    const row = Math.floor(hour / carpet.step_h);
    return day >= 0 && day < days && row >= 0 && row < carpet.rows && number >= 0 && number < carpet.variants.length ? [day, row] : null;
  };
  const key = (event: KeyboardEvent) => {
    const way = ({ ArrowUp: [0, 1], ArrowDown: [0, -1], ArrowLeft: [-1, 0], ArrowRight: [1, 0], PageUp: [30, 0], PageDown: [-30, 0] } as Record<string, [number, number]>)[event.key];
    if (!way) return;
    event.preventDefault();
    const from = picked ?? [0, Math.floor(12 / carpet.step_h)];
    onPick([Math.min(Math.max(from[0] + way[0], 0), days - 1), Math.min(Math.max(from[1] + way[1], 0), carpet.rows - 1)]);
  };
  const edges = days > 40 ? carpet.days.flatMap((day, k) => (day.endsWith("-01") ? [k] : [])) : carpet.days.flatMap((_, k) => (k % Math.ceil(days / 12) === 0 ? [k] : []));
  const sun = (hours: Numbers | null, number: number) => {
    if (!hours) return "";
    let path = "";
    hours.forEach((hour, day) => {
      const isStep = day === 0 || hours[day - 1] === null || Math.abs((hours[day - 1] as number) - (hour ?? 0)) > 2;
      if (hour !== null) path += `${isStep ? "M" : "L"}${x(day + 0.5).toFixed(1)} ${y(number, hour).toFixed(1)}`;
    });
    return path;
  };
  const cross = (cell: [number, number], name: string) =>
    carpet.variants.map((one, number) => {
      const [a, b] = [x(cell[0]), y(number, (cell[1] + 1) * carpet.step_h)];
      const [w, h] = [Math.max(inner / days, 3), (EACH * carpet.step_h) / 24];
      return <rect key={name + one.label} class={name} x={a - (w - inner / days) / 2} y={b} width={w} height={h} />;
    });
  const high = Math.min(carpet.variants.length * block - GAP - TOP, 260);
  const share = (value: number) => Math.log(value / carpet.low) / Math.log(carpet.high / carpet.low);
  return (
    <svg
      ref={drawing}
      class="drawing carpets picks"
      viewBox={`0 0 ${WIDE} ${tall}`}
      role="application"
      aria-label={label}
      tabindex={0}
      onMouseMove={(event) => onMove(cellAt(event))}
      onMouseLeave={() => onMove(null)}
      onClick={(event) => {
        const cell = cellAt(event);
        if (cell) onPick(cell);
      }}
      onKeyDown={key}
    >
      {carpet.variants.map((one, number) => (
        <g key={one.label}>
          <text class="planTitle" x={LEFT} y={number * block + TOP - 7}>
            {one.label}
          </text>
          <image href={pictures[number]} x={LEFT} y={number * block + TOP} width={inner} height={EACH} preserveAspectRatio="none" />
          {edges.slice(1).map((day) => (
            <path key={day} class="monthLine" d={`M${x(day)} ${y(number, 0)}v${-EACH}`} />
          ))}
          {[carpet.sunrise, carpet.sunset].map((hours, k) => (
            <g key={k}>
              <path class="sunLineBack" d={sun(hours, number)} />
              <path class="sunLine" d={sun(hours, number)} />
            </g>
          ))}
          <rect class="carpetFrame" x={LEFT} y={number * block + TOP} width={inner} height={EACH} />
          {[0, 6, 12, 18, 24].map((hour) => (
            <text key={hour} class="small faint" x={LEFT - 7} y={y(number, hour)} text-anchor="end" dominant-baseline="central">
              {hour}
            </text>
          ))}
        </g>
      ))}
      <text class="small faint" x={4} y={14}>
        {hourWord}
      </text>
      {edges.map((day, k) => {
        const next = edges[k + 1] ?? days;
        const name = days > 40 ? months[Number(carpet.days[day].slice(5, 7)) - 1] : carpet.days[day].slice(8).replace(/^0/, "") + " " + months[Number(carpet.days[day].slice(5, 7)) - 1];
        return next - day > days / 40 || days <= 40 ? (
          <text key={day} class="small faint" x={x((day + next) / 2)} y={tall - 10} text-anchor="middle">
            {name}
          </text>
        ) : null;
      })}
      {picked && cross(picked, "pickedCell")}
      {cursor && cross(cursor, "cursorCell")}
      <g transform={`translate(${WIDE - RIGHT + 14} ${TOP})`}>
        {Array.from({ length: 64 }, (_, k) => (
          <rect key={k} x={0} y={high * (1 - (k + 1) / 64)} width={13} height={high / 64 + 0.6} fill={cividis((k + 0.5) / 64)} />
        ))}
        <rect x={0} y={high + 12} width={13} height={9} fill={NIGHT} />
        {carpet.ticks.map((tick) => (
          <text key={tick} class="small" x={18} y={high * (1 - share(tick))} dominant-baseline="central">
            {written(tick, "lx")}
          </text>
        ))}
        <text class="small" x={18} y={high + 17} dominant-baseline="central">
          0
        </text>
        <text class="small faint" x={0} y={-8}>
          {carpet.unit}
        </text>
      </g>
    </svg>
  );
}

/** The cells as a picture. */
function painted(carpet: Carpet, values: Numbers, onlyUse: boolean, isDark: boolean): string {
  const [days, rows] = [carpet.days.length, carpet.rows];
  const canvas = document.createElement("canvas");
  const across = days > 60 ? ACROSS : Math.ceil(1460 / days);
  const up = Math.max(1, Math.round((UP * 24) / rows));
  canvas.width = days * across;
  canvas.height = rows * up;
  const pen = canvas.getContext("2d");
  if (!pen) return "";
  const span = Math.log(carpet.high / carpet.low);
  for (let row = 0; row < rows; row++)
    for (let day = 0; day < days; day++) {
      const value = values[row * days + day];
      // an hour that the clock skips lies in the night
      pen.fillStyle = value !== null && value > 0 ? cividis(Math.log(Math.max(value, carpet.low) / carpet.low) / span) : NIGHT;
      pen.globalAlpha = onlyUse && !carpet.in_use[row * days + day] ? (isDark ? 0.22 : 0.16) : 1;
      pen.fillRect(day * across, (rows - 1 - row) * up, across, up);
    }
  return canvas.toDataURL();
}
