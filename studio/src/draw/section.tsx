// The section of a panel to scale, its beams, and the sun that can be dragged about it.

import { useRef } from "preact/hooks";
import type { Point, Section, Strip } from "../server/answers";
import { ofBeam } from "./colours";
import { pointed } from "./pointed";

interface Props {
  section: Section | null;
  elevation: number;
  azimuth: number;
  side: string;
  isDark: boolean;
  isStale: boolean;
  label: string;
  sunLabel: string;
  outside: string;
  room: string;
  onSun: (elevation: number) => void;
}

const WIDE = 640;
const HIGH = 460;
const FOOT = 34;

export function DrawSection({ section, elevation, azimuth, side, isDark, isStale, label, sunLabel, outside, room, onSun }: Props) {
  const drawing = useRef<SVGSVGElement>(null);
  if (!section) return <svg class="drawing" viewBox={`0 0 ${WIDE} ${HIGH}`} role="img" aria-label={label} />;
  const scale = (HIGH - FOOT) / (section.high_mm - section.low_mm);
  const middle = 0.5 * (section.front_mm + section.back_mm);
  const px = ([z, y]: Point): Point => [WIDE / 2 + (z - middle) * scale, (section.high_mm - y) * scale];
  const path = (points: Point[], closes: boolean) => `M${points.map((one) => px(one).map((v) => v.toFixed(1)).join(" ")).join("L")}${closes ? "Z" : ""}`;
  const reach = (WIDE + HIGH) / scale;
  const strips = section.strips.map((strip, place) => ({ ...strip, corners: extended(strip, place === 0, reach) }));
  const order = [...strips].sort((one, other) => one.power - other.power);
  const first = section.strips[0];
  const meets = first ? px([0.5 * (first.corners[2][0] + first.corners[3][0]), 0.5 * (first.corners[2][1] + first.corners[3][1])]) : ([WIDE / 2, HIGH / 2] as Point);
  const way = side === "back" ? -1 : 1;
  const slope = inSection(elevation, azimuth);
  const sun = sunAt(meets, slope, way);
  const clip = `clip-${Math.round(section.pitch_mm * 1e4)}-${Math.round(section.back_mm * 1e4)}`;

  const drag = (event: PointerEvent) => {
    if (event.type === "pointermove" && !(event.buttons & 1)) return;
    const at = pointed(drawing.current, event);
    if (!at) return;
    onSun(fromSection(Math.atan2(meets[1] - at.y, Math.max(way * (meets[0] - at.x), 1)) / RAD, azimuth));
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
  };
  const key = (event: KeyboardEvent) => {
    const step = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    onSun(elevation + step);
  };
  const [left, right] = [px([section.front_mm, 0])[0], px([section.back_mm, 0])[0]];
  const foot = HIGH - FOOT + 10;
  const rung = px([0, section.pitch_mm * Math.ceil(section.low_mm / section.pitch_mm)])[1];
  return (
    <svg ref={drawing} class={`drawing${isStale ? " stale" : ""}`} viewBox={`0 0 ${WIDE} ${HIGH}`} role="group" aria-label={label}>
      <clipPath id={clip}>
        <rect x={0} y={0} width={WIDE} height={HIGH - FOOT} />
      </clipPath>
      <g clip-path={`url(#${clip})`}>
        {section.solids.map((one, k) => (
          <path key={k} class="solid" d={path(one, true)} />
        ))}
        {order.map((strip, k) => (
          <path key={k} d={path(strip.corners, true)} fill={ofBeam(strip.power, isDark)} fill-opacity={0.8} />
        ))}
        {section.surfaces.map((one, k) => (
          <path key={k} class="surface" d={path(one, false)} />
        ))}
        {section.films.map((one, k) => (
          <path key={k} class="film" d={path(one, false)} />
        ))}
        {labels(section, px, sun).map(({ at, text }, k) => (
          <text key={k} class="plate" x={at[0]} y={at[1]} text-anchor="middle" dominant-baseline="central">
            {text}
          </text>
        ))}
      </g>
      <text class="plate small" x={8} y={16}>
        {outside}
      </text>
      <text class="plate small" x={WIDE - 8} y={16} text-anchor="end">
        {room}
      </text>
      <path class="measure" d={`M${left} ${foot}H${right}M${left} ${foot - 4}v8M${right} ${foot - 4}v8`} />
      <text class="small" x={WIDE / 2} y={foot + 17} text-anchor="middle">
        {round(section.back_mm - section.front_mm)} mm
      </text>
      <path class="measure" d={`M${right + 12} ${rung}v${-section.pitch_mm * scale}m-4 0h8m-8 ${section.pitch_mm * scale}h8`} />
      <text class="plate small" x={right + 20} y={rung - (section.pitch_mm * scale) / 2} dominant-baseline="central">
        {round(section.pitch_mm)} mm
      </text>
      <g
        class="sun"
        role="slider"
        tabindex={0}
        aria-label={sunLabel}
        aria-valuemin={-89}
        aria-valuemax={89}
        aria-valuenow={Math.round(elevation)}
        aria-valuetext={`${elevation.toFixed(1)}°`}
        onPointerDown={drag}
        onPointerMove={drag}
        onKeyDown={key}
      >
        <circle class="halo" cx={sun[0]} cy={sun[1]} r={24} />
        <circle class="disc" cx={sun[0]} cy={sun[1]} r={13} />
        <text class="plate small" x={sun[0]} y={sun[1] + (slope > 0 ? 36 : -28)} text-anchor="middle">
          {elevation.toFixed(1)}°
        </text>
      </g>
    </svg>
  );
}

const RAD = Math.PI / 180;

/** The angle at which light of an elevation and azimuth is seen in the section, and back. */
const inSection = (elevation: number, azimuth: number): number => Math.atan2(Math.tan(elevation * RAD), Math.cos(azimuth * RAD)) / RAD;
const fromSection = (slope: number, azimuth: number): number => Math.atan(Math.tan(slope * RAD) * Math.cos(azimuth * RAD)) / RAD;

/** On the way that the light comes, as far out as the drawing has room. */
function sunAt(meets: Point, slope: number, way: number): Point {
  const e = slope * RAD;
  const across = (way > 0 ? meets[0] - 34 : WIDE - 34 - meets[0]) / Math.max(Math.cos(e), 1e-6);
  const up = (slope > 0 ? meets[1] - 30 : HIGH - FOOT - 30 - meets[1]) / Math.max(Math.abs(Math.sin(e)), 1e-6);
  const far = Math.max(Math.min(across, up, 300), 40);
  return [meets[0] - way * far * Math.cos(e), meets[1] - far * Math.sin(e)];
}

/** Light that has left goes on to the edge of the drawing, and light that arrives comes from there. */
function extended(strip: Strip, arrives: boolean, reach: number): Point[] {
  const [a, b, c, d] = strip.corners;
  const on = (from: Point, to: Point): Point => {
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
    return [from[0] + ((to[0] - from[0]) / length) * reach, from[1] + ((to[1] - from[1]) / length) * reach];
  };
  if (arrives) return [on(d, a), on(c, b), c, d];
  return strip.leaves ? [a, b, on(b, c), on(a, d)] : strip.corners;
}

/** The share of each direction that leaves, where its strongest strip meets the edge of the drawing. */
function labels(section: Section, px: (point: Point) => Point, sun: Point): { at: Point; text: string }[] {
  const groups = new Map<number, { power: number; best: Strip }>();
  for (const strip of section.strips) {
    if (!strip.leaves) continue;
    const [a, , , d] = strip.corners;
    const slope = Math.round((Math.atan2(d[1] - a[1], d[0] - a[0]) * 1800) / Math.PI);
    const group = groups.get(slope) ?? { power: 0, best: strip };
    groups.set(slope, { power: group.power + strip.power, best: strip.power > group.best.power ? strip : group.best });
  }
  const found: { at: Point; text: string }[] = [];
  for (const { power, best } of [...groups.values()].sort((one, other) => other.power - one.power)) {
    if (power < 0.02) continue;
    const [a, b, c, d] = best.corners.map(px);
    const start: Point = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
    const way: Point = [(c[0] + d[0] - a[0] - b[0]) / 2, (c[1] + d[1] - a[1] - b[1]) / 2];
    const toSide = way[0] ? ((way[0] > 0 ? WIDE : 0) - start[0]) / way[0] : Infinity;
    const toTop = way[1] ? ((way[1] > 0 ? HIGH - FOOT : 0) - start[1]) / way[1] : Infinity;
    const rim = Math.min(toSide, toTop);
    const on = (far: number): Point => [start[0] + far * way[0], start[1] + far * way[1]];
    // near the rim, unless the sun or another label is there
    const isFree = (at: Point) => Math.hypot(at[0] - sun[0], at[1] - sun[1]) > 52 && found.every((one) => Math.hypot(at[0] - one.at[0], 1.6 * (at[1] - one.at[1])) > 40);
    const far = [0.84, 0.7, 0.56, 0.42].find((share) => isFree(on(share * rim)));
    if (rim > 0 && far) found.push({ at: on(far * rim), text: `${(100 * power).toFixed(0)} %` });
  }
  return found;
}

const round = (value: number): string => String(Number(value.toPrecision(3)));
