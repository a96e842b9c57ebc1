// Arithmetic of points in space, for drawing.

import type { Vec } from "./answers";

export const plus = (a: Vec, b: Vec, times = 1): Vec => [a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]];
export const minus = (a: Vec, b: Vec): Vec => plus(a, b, -1);
export const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec, b: Vec): Vec => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const long = (a: Vec): number => Math.hypot(...a);
export const unit = (a: Vec): Vec => plus([0, 0, 0], a, 1 / (long(a) || 1));
export const between = (a: Vec, b: Vec, share: number): Vec => plus(plus([0, 0, 0], a, 1 - share), b, share);

export function middle(points: Vec[]): Vec {
  const sum = points.reduce((all, one) => plus(all, one), [0, 0, 0] as Vec);
  return plus([0, 0, 0], sum, 1 / Math.max(points.length, 1));
}

export function box(points: Vec[]): [Vec, Vec] {
  const low: Vec = [Infinity, Infinity, Infinity];
  const high: Vec = [-Infinity, -Infinity, -Infinity];
  for (const point of points)
    for (let k = 0; k < 3; k++) {
      low[k] = Math.min(low[k], point[k]);
      high[k] = Math.max(high[k], point[k]);
    }
  return [low, high];
}

/** Of a polygon, by all of its corners. */
export function normalOf(corners: Vec[]): Vec {
  let sum: Vec = [0, 0, 0];
  corners.forEach((a, k) => (sum = plus(sum, cross(a, corners[(k + 1) % corners.length]))));
  return unit(sum);
}
