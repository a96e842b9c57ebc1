// Colours that are told apart without telling hues apart.

type Stop = readonly [number, number, number];

// cividis at sevenths (J. R. Nuñez, C. R. Anderton, R. S. Renslow, PLOS ONE 13(7), 2018)
const CIVIDIS: Stop[] = [
  [0, 34, 78],
  [33, 59, 110],
  [76, 85, 108],
  [108, 110, 114],
  [142, 137, 120],
  [177, 165, 112],
  [217, 197, 92],
  [254, 232, 56],
];
const PALE_TO_DEEP: Stop[] = [
  [255, 240, 184],
  [255, 224, 138],
  [255, 191, 46],
  [245, 138, 0],
  [214, 90, 0],
];
const DIM_TO_BRIGHT: Stop[] = [
  [84, 54, 14],
  [140, 82, 10],
  [205, 122, 10],
  [255, 183, 51],
  [255, 240, 190],
];

function between(stops: Stop[], share: number): string {
  const at = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
  const low = Math.min(Math.floor(at), stops.length - 2);
  const mixed = stops[low].map((value, k) => Math.round(value + (stops[low + 1][k] - value) * (at - low)));
  return `rgb(${mixed.join(",")})`;
}

export const cividis = (share: number): string => between(CIVIDIS, share);

/** Of a beam, by the logarithm of its share from 1 % to all. */
export function ofBeam(power: number, isDark: boolean): string {
  const share = 1 + Math.log10(Math.max(power, 0.005)) / 2;
  return between(isDark ? DIM_TO_BRIGHT : PALE_TO_DEEP, share);
}

/** Okabe and Ito's colours, for lines and bars. */
export const HUES: Record<string, string> = {
  transmittance_deflected: "#E69F00",
  transmittance_undeflected: "#56B4E9",
  reflectance: "#009E73",
  absorptance: "#8a8f98",
  residual: "#CC79A7",
  transmittance: "#0072B2",
};
/** Of the blocks of a BSDF. */
export const OF_BLOCK: Record<string, string> = { Transmitted: HUES.transmittance, Reflected: HUES.reflectance };

/** Blue over white to brown, for differences of either sign (Okabe and Ito's blue and vermilion at the ends). */
const BLUE_TO_BROWN: Stop[] = [
  [0, 84, 140],
  [96, 160, 205],
  [240, 240, 238],
  [232, 150, 96],
  [176, 64, 0],
];
export const ofDifference = (share: number): string => between(BLUE_TO_BROWN, share);

/** Colours of categories, Okabe and Ito's, and the shapes that tell them apart without colour. */
export const CATEGORIES = ["#0072B2", "#E69F00", "#009E73", "#CC79A7", "#56B4E9", "#D55E00", "#8a8f98"];
export const DASHES = ["", "7 3", "2 3", "9 3 2 3", "4 4", "1 4", "12 4"];
export const categoryOf = (number: number): string => CATEGORIES[number % CATEGORIES.length];
export const dashOf = (number: number): string => DASHES[number % DASHES.length];

/** Shapes of marks by number, within 5 of their middle. */
const MARKS = ["M-5 0A5 5 0 1 1 5 0A5 5 0 1 1 -5 0Z", "M-4.4 -4.4H4.4V4.4H-4.4Z", "M0 -6L6 0L0 6L-6 0Z", "M0 -5.6L5.4 4.4H-5.4Z", "M0 5.6L5.4 -4.4H-5.4Z", "M-2 -5.5H2V-2H5.5V2H2V5.5H-2V2H-5.5V-2H-2Z", "M-5 -3L0 -6L5 -3V3L0 6L-5 3Z"];
export const markOf = (number: number): string => MARKS[number % MARKS.length];
