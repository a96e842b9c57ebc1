// Numbers as they are read.

const DIGITS: Record<string, number> = { "%": 1, lx: 0, h: 0, "lx h": 0, m: 2, "°": 1 };

/** With thin spaces between thousands; three figures, or as many as are usual with its unit. */
export function written(value: number | null | undefined, unit = ""): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const digits = DIGITS[unit];
  const size = Math.abs(value);
  const most = digits === undefined || (size < 10 && size > 0 && digits < 2) ? Math.min(unit === "%" ? 2 : 6, Math.max(0, 2 - Math.floor(Math.log10(size || 1)))) : digits;
  return grouped(value.toLocaleString("en", { maximumFractionDigits: most, useGrouping: false }), size);
}

/** With its unit, and its standard error where it is known. */
export function writtenWith(value: number | null | undefined, unit: string, error?: number | null): string {
  const about = error !== null && error !== undefined && error > 0 && value !== null ? ` ± ${written(error, unit)}` : "";
  return `${written(value, unit)}${about}${unit && value !== null ? `\u00a0${unit}` : ""}`;
}

/** A value and its standard error, both to the digits that the error leaves. */
export function unsure(value: number, error: number | null | undefined): { value: string; error: string } {
  if (!error || !Number.isFinite(error)) return { value: written(value), error: "" };
  const digits = Math.min(6, Math.max(0, -Math.floor(Math.log10(error) - Math.log10(2))));
  const put = (one: number) => grouped(one.toFixed(digits), Math.abs(one));
  return { value: put(value), error: put(error) };
}

function grouped(text: string, size: number): string {
  const [whole, part] = text.replace(/^-/, "−").split(".");
  const spaced = size >= 10_000 ? whole.replace(/\B(?=(\d{3})+$)/g, "\u202f") : whole;
  return part === undefined ? spaced : `${spaced}.${part}`;
}
