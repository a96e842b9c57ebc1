// Lines along which values on a grid are equal, by linear interpolation between neighbours.

import type { Point } from "../server/answers";

/** Places in a list of points of the four that stand around a square, in their order about it. */
export type Square = [number, number, number, number];

/** Squares of a grid whose points stand row by row. */
export function squaresOf(columns: number, rows: number): Square[] {
  const found: Square[] = [];
  for (let row = 0; row + 1 < rows; row++)
    for (let column = 0; column + 1 < columns; column++) {
      const k = row * columns + column;
      found.push([k, k + 1, k + 1 + columns, k + columns]);
    }
  return found;
}

/** Squares of a grid of which some points may be missing, told by the row and the column of each. */
export function squaresAt(row: number[], column: number[]): Square[] {
  const at = new Map(row.map((r, k) => [`${r} ${column[k]}`, k]));
  return row.flatMap((r, k) => {
    const c = column[k];
    const square = [k, at.get(`${r} ${c + 1}`), at.get(`${r + 1} ${c + 1}`), at.get(`${r + 1} ${c}`)];
    return square.includes(undefined) ? [] : [square as Square];
  });
}

/** Pieces of the line along which values are `level`: each square that knows its values crossed straight. */
export function contour(squares: Square[], points: Point[], values: (number | null)[], level: number): [Point, Point][] {
  const found: [Point, Point][] = [];
  for (const square of squares) {
    if (square.some((k) => values[k] === null)) continue;
    const crossings: Point[] = [];
    square.forEach((one, side) => {
      const next = square[(side + 1) % 4];
      const [a, b] = [(values[one] as number) - level, (values[next] as number) - level];
      if (a >= 0 === b >= 0) return;
      const share = a / (a - b);
      const [[x, y], [toX, toY]] = [points[one], points[next]];
      crossings.push([x + share * (toX - x), y + share * (toY - y)]);
    });
    for (let k = 0; k + 1 < crossings.length; k += 2) found.push([crossings[k], crossings[k + 1]]);
  }
  return found;
}
