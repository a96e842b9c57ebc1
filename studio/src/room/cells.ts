// The squares that sensors stand for.

import type { Plane, Vec } from "./answers";
import { cross, plus, unit } from "./space";

/** The four corners of each sensor's cell; a square about it where the server tells none. */
export function cellsOf(plane: Plane): Vec[][] {
  if (plane.cells) return plane.cells;
  const half = (plane.spacing_m ?? 0.3) / 2;
  return plane.points_m.map((point, k) => {
    const normal = plane.normals[k];
    const across = unit(cross(Math.abs(normal[2]) > 0.9 ? [0, 1, 0] : [0, 0, 1], normal));
    const up = cross(normal, across);
    return [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) => plus(plus(point, across, a * half), up, b * half));
  });
}
