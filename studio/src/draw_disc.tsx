// Discs of directions: the normal in the middle, 90° at the rim.

import { useRef } from "preact/hooks";
import type { Point } from "./answers";
import { cividis } from "./colours";

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
}

export function DrawDisc({ title, label, cells, values, isLogarithmic, least, most, unit, up, right, nothing, point, picked, onPick }: Props) {
  const drawing = useRef<SVGSVGElement>(null);
  const share = (value: number) => (isLogarithmic ? Math.log(value / least) / Math.log(most / least) : value / most);
  const path = (cell: Point[]) => `M${cell.map(([x, y]) => `${x} ${-y}`).join("L")}Z`;
  const isLit = values.some((value) => value > 0);
  const pick = (event: MouseEvent) => {
    const matrix = drawing.current?.getScreenCTM();
    if (!matrix || !onPick) return;
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    if (Math.hypot(at.x, at.y) < 90) onPick([at.x, -at.y]);
  };
  const key = (event: KeyboardEvent) => {
    const step = ({ ArrowUp: [0, 5], ArrowDown: [0, -5], ArrowLeft: [-5, 0], ArrowRight: [5, 0] } as Record<string, Point>)[event.key];
    if (!step || !onPick || !point) return;
    event.preventDefault();
    const to: Point = [point[0] + step[0], point[1] + step[1]];
    if (Math.hypot(...to) < 89) onPick(to);
  };
  const said = (value: number) => Number(value.toPrecision(2)).toString();
  return (
    <svg
      ref={drawing}
      class={`drawing disc${onPick ? " picks" : ""}`}
      viewBox="-104 -118 208 240"
      role={onPick ? "application" : "img"}
      aria-label={label}
      tabindex={onPick ? 0 : undefined}
      onClick={onPick ? pick : undefined}
      onKeyDown={onPick ? key : undefined}
    >
      <text class="discTitle" x={0} y={-108} text-anchor="middle">
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
