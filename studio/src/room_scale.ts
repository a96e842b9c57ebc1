// A scale of values: its range, its ticks, and where a value stands in it.

import { ticks as linear } from "./ticks";

export interface Scale {
  low: number;
  high: number;
  isLog: boolean;
}

/** A range of round numbers about values; fixed ends, if above 0, stay as they are. */
export function scaleOf(values: number[], isLog: boolean, fixedLow = 0, fixedHigh = 0): Scale {
  const finite = values.filter((one) => Number.isFinite(one));
  const most = Math.max(...finite, 1e-9);
  const positive = finite.filter((one) => one > 0);
  const high = fixedHigh > 0 ? fixedHigh : rounded(most, true);
  if (!isLog) return { low: fixedLow > 0 && fixedLow < high ? fixedLow : 0, high, isLog };
  const least = Math.max(positive.length ? Math.min(...positive) : high / 100, high / 1e4);
  const low = fixedLow > 0 && fixedLow < high ? fixedLow : Math.min(rounded(least, false), high / 4);
  return { low, high, isLog };
}

/** The next of 1, 1.5, 2, 3, 4, 5, 6, 8 times a power of ten. */
function rounded(value: number, isUp: boolean): number {
  const power = 10 ** Math.floor(Math.log10(value));
  const steps = [1, 1.5, 2, 3, 4, 5, 6, 8, 10].map((one) => one * power);
  const found = isUp ? steps.find((one) => one >= value * (1 - 1e-9)) : [...steps].reverse().find((one) => one <= value * (1 + 1e-9));
  return Number((found ?? value).toPrecision(6));
}

export function share(scale: Scale, value: number): number {
  if (scale.isLog) return value <= scale.low ? 0 : Math.min(1, Math.log(value / scale.low) / Math.log(scale.high / scale.low));
  return Math.min(1, Math.max(0, (value - scale.low) / (scale.high - scale.low)));
}

export function ticks(scale: Scale, about = 5): number[] {
  if (!scale.isLog) return linear(scale.low, scale.high, about);
  const found: number[] = [];
  const decades = Math.log10(scale.high / scale.low);
  for (const steps of [[1, 2, 3, 5], [1, 2, 5], [1, 3], [1]]) {
    found.length = 0;
    for (let power = Math.floor(Math.log10(scale.low)); power <= Math.ceil(Math.log10(scale.high)); power++)
      for (const one of steps) {
        const value = Number((one * 10 ** power).toPrecision(6));
        if (value >= scale.low * (1 - 1e-9) && value <= scale.high * (1 + 1e-9)) found.push(value);
      }
    if (found.length <= Math.max(about + 2, decades)) break;
  }
  return found;
}

/** A value and its standard error, both to the digits that the error leaves. */
export function unsure(value: number, error: number | null | undefined): { value: string; error: string } {
  if (!error || !Number.isFinite(error)) return { value: written(value), error: "" };
  const digits = Math.min(6, Math.max(0, -Math.floor(Math.log10(error) - Math.log10(2))));
  const put = (one: number) => grouped(one.toFixed(digits), one);
  return { value: put(value), error: put(error) };
}

const grouped = (text: string, value: number) => (Math.abs(value) >= 10_000 ? text.replace(/\B(?=(\d{3})+$)/g, "\u202f") : text);

/** As people write it: three figures, no dust. */
export function written(value: number): string {
  if (!Number.isFinite(value)) return "–";
  if (value !== 0 && Math.abs(value) < 0.005) return value.toExponential(1);
  const digits = Math.abs(value) >= 100 ? 0 : Math.abs(value) >= 10 ? 1 : Math.abs(value) >= 1 ? 2 : 3;
  const text = value.toLocaleString("en", { maximumFractionDigits: digits, useGrouping: false });
  return grouped(text, value);
}
