// Discs of directions: the normal in the middle, 90° at the rim.

import { useRef, useState } from "preact/hooks";
import type { Point } from "../server/answers";
import { cividis } from "./colours";
import { pointed } from "./pointed";

/** Of a title; a longer one is made narrower. */
const MOST_LETTERS = 34;

interface Props {
  title: string;
  label: string;
  cells: Point[][];
  values: number[];
  isLogarithmic: boolean;
  least: number;
  most: number;
  unit: string;
  up: string;
  right: string;
  nothing: string;
  point?: Point;
  picked?: number;
  onPick?: (point: Point) => void;
  /** Says the value of the cell that a pointer or the arrow keys are at. */
  reads?: (theta: number, phi: number, value: string) => string;
}

export function DrawDisc({ title, label, cells, values, isLogarithmic, least, most, unit, up, right, nothing, point, picked, onPick, reads }: Props) {
  const drawing = useRef<SVGSVGElement>(null);
  const share = (value: number) => (isLogarithmic ? Math.log(value / least) / Math.log(most / least) : value / most);
  const path = (cell: Point[]) => `M${cell.map(([x, y]) => `${x} ${-y}`).join("L")}Z`;
  const isLit = values.some((value) => value > 0);
  const [cursor, setCursor] = useState<Point | null>(null);
  const placed = (event: MouseEvent): Point | null => {
    const at = pointed(drawing.current, event);
    return at && Math.hypot(at.x, at.y) < 90 ? [at.x, -at.y] : null;
  };
  const pick = (event: MouseEvent) => {
    const at = placed(event);
    if (at) onPick?.(at);
  };
  const hover = (event: MouseEvent) => {
    setCursor(placed(event));
    if (onPick && event.buttons & 1) pick(event);
  };
  const under = cursor ? cells.findIndex((cell) => holds(cell, cursor)) : -1;
  const told = reads && cursor ? reads(Math.hypot(...cursor), (Math.atan2(cursor[1], cursor[0]) * 180) / Math.PI, under >= 0 ? `${said(values[under])} ${unit}` : nothing) : "";
  const key = (event: KeyboardEvent) => {
    const step = ({ ArrowUp: [0, 5], ArrowDown: [0, -5], ArrowLeft: [-5, 0], ArrowRight: [5, 0] } as Record<string, Point>)[event.key];
    if (!step) return;
    event.preventDefault();
    const from = onPick ? point : (cursor ?? point ?? [0, 0]);
    if (!from) return;
    const to: Point = [from[0] + step[0], from[1] + step[1]];
    if (Math.hypot(...to) >= 89) return;
    if (onPick) onPick(to);
    setCursor(to);
  };
  return (
    <svg
      ref={drawing}
      class={`drawing disc${onPick ? " picks" : ""}`}
      viewBox="-104 -118 208 240"
      role={onPick || reads ? "application" : "img"}
      aria-label={label}
      tabindex={onPick || reads ? 0 : undefined}
      onPointerDown={onPick ? pick : undefined}
      onPointerMove={onPick || reads ? hover : undefined}
      onPointerLeave={() => setCursor(null)}
      onKeyDown={onPick || reads ? key : undefined}
    >
      <text class="discTitle" x={0} y={-108} text-anchor="middle" textLength={title.length > MOST_LETTERS ? 200 : undefined} lengthAdjust="spacingAndGlyphs">
        {title}
      </text>
      <circle class="rim" r={90} />
      {cells.map((cell, k) => {
        if (!(values[k] > 0)) return null;
        const colour = cividis(share(Math.max(values[k], isLogarithmic ? least : 0)));
        return <path key={k} d={path(cell)} fill={colour} stroke={colour} stroke-width={0.4} />;
      })}
      {[30, 60].map((r) => (
        <circle key={r} class="ring" r={r} />
      ))}
      {picked !== undefined && cells[picked] && <path class="pickedPatch" d={path(cells[picked])} />}
      {point && <path class="cross" d={`M${point[0] - 4} ${-point[1]}h8M${point[0]} ${-point[1] - 4}v8`} />}
      {reads && under >= 0 && <path class="readPatch" d={path(cells[under])} />}
      {!isLit && (
        <text class="faint discSmall" text-anchor="middle">
          {nothing}
        </text>
      )}
      <text class="faint discSmall" x={0} y={-93} text-anchor="middle">
        {up}
      </text>
      <text class="faint discSmall" x={93} y={0} transform="rotate(90 93 0)" text-anchor="middle">
        {right}
      </text>
      {told && (
        <text class="discSmall plate" x={0} y={90} text-anchor="middle" role="status">
          {told}
        </text>
      )}
      {Array.from({ length: 40 }, (_, k) => (
        <rect key={k} x={-60 + 3 * k} y={100} width={3.1} height={6} fill={cividis(k / 39)} />
      ))}
      <text class="discSmall" x={-60} y={115} text-anchor="middle">
        {said(isLogarithmic ? least : 0)}
      </text>
      <text class="discSmall" x={60} y={115} text-anchor="middle">
        {said(most)}
      </text>
      <text class="faint discSmall" x={0} y={115} text-anchor="middle">
        {unit}
      </text>
    </svg>
  );
}

const said = (value: number): string => Number(value.toPrecision(3)).toString();

/** Whether a point lies within an outline: crossings of a ray to the right are odd. */
function holds(cell: Point[], [x, y]: Point): boolean {
  let isWithin = false;
  for (let k = 0, j = cell.length - 1; k < cell.length; j = k++) {
    const [[xk, yk], [xj, yj]] = [cell[k], cell[j]];
    if (yk > y !== yj > y && x < ((xj - xk) * (y - yk)) / (yj - yk) + xk) isWithin = !isWithin;
  }
  return isWithin;
}
