// A plane of sensors as a drawing: laid flat, its lines of equal value, a row of it.

import type { Point } from "../server/answers";
import type { Plane, RoomScene, Vec } from "./answers";
import { cellsOf } from "./cells";
import { facade } from "./eye";
import { cross, dot, minus, plus, unit } from "./space";

export interface Flat {
  /** In metres: from the window into the room to the right if the plane is level, upwards as drawn. */
  points: Point[];
  cells: Point[][];
  /** Whether the first axis leads away from the window. */
  isDepth: boolean;
  windows: [Point, Point][];
}

/** A plane seen from above with the window at the left, or a wall as seen from within. */
export function flatten(plane: Plane, scene: RoomScene): Flat {
  const out = facade(scene);
  const normal = plane.normals[0] ?? [0, 0, 1];
  const isLevel = Math.abs(normal[2]) > 0.7;
  const u: Vec = isLevel ? plus([0, 0, 0], out, -1) : unit(cross(plus([0, 0, 0], normal, -1), [0, 0, 1]));
  const v: Vec = isLevel ? cross(out, [0, 0, 1]) : [0, 0, 1];
  const window = scene.windows.find((one) => Math.abs(one.normal[2]) < 0.7);
  const from = window ? window.outline_m[0] : scene.inside_m[0];
  const isDepth = Math.abs(dot(u, out)) > 0.9;
  const zero = isDepth ? from : plane.points_m[0];
  const sign = isDepth && dot(u, out) > 0 ? -1 : 1;
  const put = (point: Vec): Point => [sign * dot(minus(point, zero), u), dot(minus(point, [0, 0, 0]), v)];
  const windows = isLevel ? scene.windows.filter((one) => Math.abs(one.normal[2]) < 0.7).map((one) => ends(one.outline_m.map(put))) : [];
  return { points: plane.points_m.map(put), cells: cellsOf(plane).map((cell) => cell.map(put)), isDepth: isDepth, windows };
}

/** The two corners of a level outline that are farthest apart. */
function ends(points: Point[]): [Point, Point] {
  let best: [Point, Point] = [points[0], points[0]];
  for (const a of points) for (const b of points) if (Math.hypot(a[0] - b[0], a[1] - b[1]) > Math.hypot(best[0][0] - best[1][0], best[0][1] - best[1][1])) best = [a, b];
  return best;
}

export interface Along {
  /** Sensors of the line through the chosen one. */
  sensors: number[];
  /** Least and most across it, by distance. */
  band: { at: number; least: number; most: number }[];
}

export function along(flat: Flat, values: number[], picked: number): Along {
  const middle = flat.points.reduce((sum, one) => sum + one[1], 0) / Math.max(flat.points.length, 1);
  const gap = (v: number, w: number) => Math.abs(v - w);
  const line = picked >= 0 && picked < flat.points.length ? flat.points[picked][1] : [...flat.points].sort((a, b) => gap(a[1], middle) - gap(b[1], middle))[0]?.[1] ?? 0;
  const sensors = flat.points.map((_, k) => k).filter((k) => gap(flat.points[k][1], line) < 1e-3);
  const rows = new Map<string, { at: number; least: number; most: number }>();
  flat.points.forEach(([at], k) => {
    const key = at.toFixed(3);
    const old = rows.get(key) ?? { at, least: Infinity, most: -Infinity };
    rows.set(key, { at, least: Math.min(old.least, values[k]), most: Math.max(old.most, values[k]) });
  });
  const near = (a: number, b: number) => flat.points[a][0] - flat.points[b][0];
  return { sensors: sensors.sort(near), band: [...rows.values()].sort((a, b) => a.at - b.at) };
}

/** The sensor beside another in a direction of the drawing. */
export function beside(flat: Flat, from: number, key: string): number {
  const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[key];
  if (!way) return from;
  const start = flat.points[Math.max(from, 0)];
  let best = { k: from, far: Infinity };
  flat.points.forEach(([x, y], k) => {
    const [dx, dy] = [x - start[0], y - start[1]];
    const ahead = dx * way[0] + dy * way[1];
    const aside = Math.abs(dx * way[1]) + Math.abs(dy * way[0]);
    if (ahead > 1e-6 && ahead + 3 * aside < best.far) best = { k, far: ahead + 3 * aside };
  });
  return best.k;
}
