// The plan of a plane in false colours, with lines of equal value or the values, and the chosen sensor.

import { cividis } from "../draw/colours";
import { contour, squaresAt } from "../draw/contours";
import { written } from "../draw/written";
import type { Point } from "../server/answers";
import type { Plane } from "./answers";
import { beside, type Flat } from "./flat";
import { type Scale, share, ticks } from "./scale";

interface Props {
  plane: Plane;
  flat: Flat;
  values: number[];
  scale: Scale;
  unit: string;
  picked: number;
  isStale: boolean;
  hasValues: boolean;
  label: string;
  told: (sensor: number) => string;
  onPick: (sensor: number) => void;
}

const WIDE = 640;
const EDGE = 14;
const BAR = 46;

export function DrawPlan({ plane, flat, values, scale, unit, picked, isStale, hasValues, label, told, onPick }: Props) {
  const all = [...flat.cells.flat(), ...flat.windows.flat()];
  const [left, right] = [Math.min(...all.map((one) => one[0])), Math.max(...all.map((one) => one[0]))];
  const [low, high] = [Math.min(...all.map((one) => one[1])), Math.max(...all.map((one) => one[1]))];
  const size = Math.min((WIDE - 2 * EDGE) / (right - left), 420 / (high - low));
  const tall = (high - low) * size + 2 * EDGE;
  const shift = (WIDE - (right - left) * size) / 2;
  const px = ([x, y]: Point): Point => [shift + (x - left) * size, EDGE + (high - y) * size];
  const path = (points: Point[], closes: boolean) => `M${points.map((one) => px(one).map((at) => at.toFixed(1)).join(" ")).join("L")}${closes ? "Z" : ""}`;
  const named: Point[] = [];
  const squares = plane.row && plane.column ? squaresAt(plane.row, plane.column) : [];
  const levels = ticks(scale, 6).filter((one) => one > scale.low && one < scale.high);
  const key = (event: KeyboardEvent) => {
    const to = beside(flat, picked, event.key);
    if (to === picked && !event.key.startsWith("Arrow")) return;
    event.preventDefault();
    onPick(to);
  };
  const cell = Math.sqrt(plane.spacing_m ? plane.spacing_m ** 2 : 0.09) * size;
  const isReadable = cell > 25;
  return (
    <svg class={`drawing plan${isStale ? " stale" : ""}`} viewBox={`0 0 ${WIDE} ${(tall + BAR).toFixed(0)}`} role="group" aria-label={label}>
      <g class="picks" role="application" tabindex={0} aria-label={picked >= 0 ? told(picked) : label} onKeyDown={key}>
        {flat.cells.map((corners, k) => (
          <path key={k} d={path(corners, true)} fill={cividis(share(scale, values[k]))} stroke={cividis(share(scale, values[k]))} stroke-width={0.6} onClick={() => onPick(k)}>
            <title>{told(k)}</title>
          </path>
        ))}
      </g>
      {hasValues && isReadable
        ? flat.points.map((point, k) => {
            const [x, y] = px(point);
            const isBright = share(scale, values[k]) > 0.55;
            return (
              <text key={k} class="value" fill={isBright ? "#10161c" : "#ffffff"} style={{ fill: isBright ? "#10161c" : "#ffffff" }} font-size={Math.min(12, cell * 0.34)} x={x} y={y} text-anchor="middle" dominant-baseline="central" pointer-events="none">
                {values[k] < 1 ? Number(values[k].toFixed(2)) : written(values[k])}
              </text>
            );
          })
        : levels.map((level) => {
            const pieces = contour(squares, flat.points, values, level);
            if (!pieces.length) return null;
            const at = px(pieces[Math.floor(pieces.length / 2)][0]);
            const isNamed = named.every((other) => Math.hypot(other[0] - at[0], 2 * (other[1] - at[1])) > 46);
            if (isNamed) named.push(at);
            const isBright = share(scale, level) > 0.55;
            const colour = isBright ? "#10161c" : "#ffffff";
            return (
              <g key={level} pointer-events="none">
                <path d={pieces.map((piece) => path(piece, false)).join("")} fill="none" stroke={colour} stroke-width={1.4} />
                {isNamed && <text class="iso" x={at[0]} y={at[1]} fill={colour} style={{ fill: colour, stroke: cividis(share(scale, level)) }} stroke={cividis(share(scale, level))} stroke-width={4} paint-order="stroke" font-size={12} text-anchor="middle" dominant-baseline="central">
                  {written(level)}
                </text>}
              </g>
            );
          })}
      {flat.windows.map((line, k) => (
        <path key={k} class="windowLine" d={path(line, false)} />
      ))}
      {flat.cells[picked] && <path class="pickedPatch" d={path(flat.cells[picked], true)} />}
      <g transform={`translate(${shift} ${tall})`}>
        <ColourBar scale={scale} unit={unit} wide={(right - left) * size} />
      </g>
    </svg>
  );
}

/** A bar of colours with its ticks, as part of a drawing. */
export function ColourBar({ scale, unit, wide }: { scale: Scale; unit: string; wide: number }) {
  const at = (value: number) => share(scale, value) * wide;
  // words need room, and the last one has the unit
  const half = (mark: number, hasUnit: boolean) => 3.6 * written(mark).length + 4 + (hasUnit ? 4 * unit.length : 0);
  const marks = ticks(scale, wide < 400 ? 4 : 6).reduceRight<number[]>((kept, mark) => (kept.length && at(kept[0]) - at(mark) < half(kept[0], kept.length === 1) + half(mark, false) ? kept : [mark, ...kept]), []);
  return (
    <g>
      {Array.from({ length: 48 }, (_, k) => (
        <rect key={k} x={(k * wide) / 48} y={6} width={wide / 48 + 0.5} height={9} fill={cividis((k + 0.5) / 48)} />
      ))}
      {marks.map((mark) => (
        <g key={mark}>
          <path class="measure" d={`M${at(mark).toFixed(1)} 15v4`} />
          <text class="small" x={at(mark)} y={32} text-anchor={at(mark) < 12 ? "start" : at(mark) > wide - 24 ? "end" : "middle"}>
            {written(mark)}
            {mark === marks[marks.length - 1] ? ` ${unit}` : ""}
          </text>
        </g>
      ))}
    </g>
  );
}
