// Round numbers for axes.

/** Round numbers from low to high, about as many as asked for. */
export function ticks(low: number, high: number, about = 5): number[] {
  const span = high - low;
  if (!(span > 0) || !Number.isFinite(span)) return [low];
  const rough = span / about;
  const decade = 10 ** Math.floor(Math.log10(rough));
  const step = ([1, 2, 5, 10].find((one) => one * decade >= rough * 0.999) ?? 10) * decade;
  const first = Math.ceil(low / step - 1e-9);
  const count = Math.floor(high / step + 1e-9) - first + 1;
  return Array.from({ length: Math.max(count, 0) }, (_, k) => Number(((first + k) * step).toPrecision(12)));
}

/** The same on a logarithmic scale, as many of 1, 2, 3, 5, 10 … as are about as many as asked for, or powers of ten alone. */
export function logTicks(low: number, high: number, about = 5): number[] {
  const most = Math.max(about + 2, Math.log10(high / low));
  let found: number[] = [];
  for (const steps of [[1, 2, 3, 5], [1, 2, 5], [1, 3], [1]]) {
    found = [];
    for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); power++)
      for (const step of steps) {
        const value = Number((step * 10 ** power).toPrecision(6));
        if (value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9)) found.push(value);
      }
    if (found.length <= most) break;
  }
  return found;
}
