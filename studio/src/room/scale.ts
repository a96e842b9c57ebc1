// A scale of values: its range, its ticks, and where a value stands in it.

import { logTicks, ticks as linear } from "../draw/ticks";

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

export function ticks({ low, high, isLog }: Scale, about = 5): number[] {
  return isLog ? logTicks(low, high, about) : linear(low, high, about);
}
