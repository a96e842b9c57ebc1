// Colours of the room's picture, told apart without telling hues apart.

import type { PathKind } from "./answers";

export interface Look {
  isDark: boolean;
  ground: string;
  /** About words. */
  halo: string;
  sheet: string;
  ink: string;
  faint: string;
  hair: string;
  edge: string;
  disc: string;
  sun: string;
  /** Of a surface of least and of greatest reflectance. */
  walls: [string, string];
  outside: string;
}

export const LIGHT: Look = {
  isDark: false,
  ground: "#eef2f5",
  halo: "rgba(245,248,250,0.75)",
  sheet: "#ffffff",
  ink: "#1d2733",
  faint: "#5d6875",
  hair: "#b9c3cd",
  edge: "#33475b",
  disc: "#e2e8ec",
  sun: "#f5a400",
  walls: ["#aab4be", "#ffffff"],
  outside: "#8fa1b3",
};
export const DARK: Look = {
  isDark: true,
  ground: "#10161c",
  halo: "rgba(16,22,28,0.75)",
  sheet: "#1a2129",
  ink: "#e8ecf0",
  faint: "#9fabb8",
  hair: "#3d4956",
  edge: "#a9bacb",
  disc: "#18212a",
  sun: "#ffc233",
  walls: ["#1d2832", "#475665"],
  outside: "#5c6f82",
};

/** Okabe and Ito's: light that goes straight, by a total reflection, and after a diffuse bounce. */
export const OF_PATH: Record<PathKind, [string, string]> = {
  direct: ["#d98200", "#ffb52e"],
  redirected: ["#0072B2", "#56B4E9"],
  reflected: ["#8a5a78", "#d79abb"],
};
export const pathColour = (kind: PathKind, isDark: boolean): string => OF_PATH[kind][isDark ? 1 : 0];

/** Of a window part: by what its glazing is. */
export function glassColour(kind: string, isDark: boolean): string {
  if (/laser/.test(kind)) return isDark ? "#ffb52e" : "#e69f00";
  if (/prism/.test(kind)) return isDark ? "#2bc49a" : "#009e73";
  if (/extruded|bsdf|measured/.test(kind)) return isDark ? "#d79abb" : "#b3689a";
  if (/open/.test(kind)) return isDark ? "#5c6f82" : "#b9c8d6";
  return isDark ? "#7cbcf2" : "#79b4dd";
}
/** Whether cuts or ridges are to be seen on a window part. */
export const isCut = (kind: string): boolean => /laser|prism|extruded/.test(kind);
