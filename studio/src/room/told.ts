// The quantity that is looked at, out of what the server told.

import type { RoomLight } from "./answers";
import type { Told } from "./numbers";

export function toldOf(light: RoomLight | null, quantity: string): Told | null {
  if (!light) return null;
  const { sky, sun_direct, sun_redirected, sun_interreflected } = light.parts;
  if (quantity === "factor" && light.daylight_factor_percent) return summed(light.daylight_factor_percent, light.daylight_factor_standard_error_percent ?? null);
  if (quantity === "sky") return summed(sky, light.sky_standard_error_lx ?? null);
  if (quantity === "sun") return summed(sun_direct.map((one, k) => one + sun_redirected[k] + sun_interreflected[k]), light.sun_standard_error_lx ?? null);
  return {
    values: light.total_lx,
    errors: light.standard_error_lx,
    mean: light.mean_lx,
    least: light.least_lx,
    most: light.most_lx,
    uniformity: light.uniformity,
    meanError: light.mean_standard_error_lx ?? null,
    uniformityError: light.uniformity_standard_error ?? null,
  };
}

function summed(values: number[], errors: number[] | null): Told {
  const mean = values.reduce((sum, one) => sum + one, 0) / Math.max(values.length, 1);
  const least = Math.min(...values);
  return { values, errors, mean, least, most: Math.max(...values), uniformity: mean > 0 ? least / mean : null, meanError: null, uniformityError: null };
}
