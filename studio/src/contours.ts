// Lines along which values on a grid are equal, by linear interpolation between neighbours.

import type { Numbers } from "./year_answers";

/** Segments of the line at a level, as the path of a drawing. */
export function contour(x: number[], y: number[], values: Numbers, level: number, place: (x: number, y: number) => string): string {
  const columns = x.length;
  const found: string[] = [];
  for (let row = 0; row + 1 < y.length; row++)
    for (let column = 0; column + 1 < columns; column++) {
      const corners = [
        [column, row],
        [column + 1, row],
        [column + 1, row + 1],
        [column, row + 1],
      ].map(([c, r]) => ({ x: x[c], y: y[r], value: values[r * columns + c] }));
      if (corners.some((one) => one.value === null)) continue;
      const crossings: string[] = [];
      corners.forEach((one, k) => {
        const next = corners[(k + 1) % 4];
        const [a, b] = [(one.value as number) - level, (next.value as number) - level];
        if (a >= 0 === b >= 0) return;
        const share = a / (a - b);
        crossings.push(place(one.x + share * (next.x - one.x), one.y + share * (next.y - one.y)));
      });
      for (let k = 0; k + 1 < crossings.length; k += 2) found.push(`M${crossings[k]}L${crossings[k + 1]}`);
    }
  return found.join("");
}
