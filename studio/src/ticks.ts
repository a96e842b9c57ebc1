// Round numbers for axes, and numbers as they are read.

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

/** The same on a logarithmic scale: 1, 2, 5, 10 … or, over many decades, 1, 10, 100 … */
export function logTicks(low: number, high: number): number[] {
  const decades = Math.log10(high / low);
  const steps = decades > 3.2 ? [1] : decades > 1.6 ? [1, 3] : [1, 2, 5];
  const found: number[] = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); power++)
    for (const step of steps) found.push(Number((step * 10 ** power).toPrecision(6)));
  return found.filter((one) => one >= low * 0.999 && one <= high * 1.001);
}

const DIGITS: Record<string, number> = { "%": 1, lx: 0, h: 0, "lx h": 0, m: 2, "°": 1 };

/** A number as it is read, with thin spaces between thousands. */
export function said(value: number | null | undefined, unit = ""): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const digits = DIGITS[unit];
  const size = Math.abs(value);
  const most = digits === undefined || (size < 10 && size > 0 && digits < 2) ? Math.min(unit === "%" ? 2 : 6, Math.max(0, 2 - Math.floor(Math.log10(size || 1)))) : digits;
  return value.toLocaleString("en", { maximumFractionDigits: most, useGrouping: size >= 10_000 }).replace(/,/g, "\u202f").replace(/^-/, "−");
}

/** With its unit, and its standard error where it is known. */
export function saidWith(value: number | null | undefined, unit: string, error?: number | null): string {
  const unsure = error !== null && error !== undefined && error > 0 && value !== null ? ` ± ${said(error, unit)}` : "";
  return `${said(value, unit)}${unsure}${unit && value !== null ? `\u00a0${unit}` : ""}`;
}
