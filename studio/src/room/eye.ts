// Where one looks at a room from, and how hands and keys move it.

import type { RoomScene, Vec } from "./answers";
import { cross, long, middle, minus, plus, unit } from "./space";

/** Turn clockwise from north and tilt above the horizon of the eye about what it looks at, in degrees. */
export interface Eye {
  turn: number;
  tilt: number;
  far: number;
  at: Vec;
  isFlat: boolean;
}
export const EYES = ["overview", "facade", "section", "plan", "back"] as const;
export type EyeName = (typeof EYES)[number];
/** Half the angle of the picture, up and down [deg]. */
export const HALF_VIEW_DEG = 16;

/** The sky over a room, on the ground and wide enough to hold it. */
export interface Dome {
  centre: Vec;
  radius: number;
}
export function domeOf(scene: RoomScene): Dome {
  const [low, high] = scene.inside_m;
  const at = middle([low, high]);
  return { centre: [at[0], at[1], Math.min(low[2], 0)], radius: 0.66 * long(minus(high, low)) };
}

const DISC = 0.75;
const RAD = Math.PI / 180;

export function place(eye: Eye): Vec {
  const [turn, tilt] = [eye.turn * RAD, eye.tilt * RAD];
  return plus(eye.at, [Math.sin(turn) * Math.cos(tilt), Math.cos(turn) * Math.cos(tilt), Math.sin(tilt)], eye.far);
}

export function facade(scene: RoomScene): Vec {
  const window = scene.windows.find((one) => Math.abs(one.normal[2]) < 0.7);
  return window ? unit([-window.normal[0], -window.normal[1], 0]) : [0, -1, 0];
}

export function eyeOf(name: EyeName, scene: RoomScene, aspect: number): Eye {
  const [low, high] = scene.inside_m;
  const out = facade(scene);
  const size = minus(high, low);
  const side = cross([0, 0, 1], out);
  const turned = (way: Vec) => ((Math.atan2(way[0], way[1]) / RAD) % 360 + 360) % 360;
  const wide = (way: Vec) => Math.abs(way[0]) * size[0] + Math.abs(way[1]) * size[1];
  // far enough that `across` by `up` metres fill the picture
  const far = (across: number, up: number) => Math.max(up, across / aspect) / 2 / Math.tan(HALF_VIEW_DEG * RAD);
  const at = middle([low, high]);
  const along = wide(side);
  const deep = wide(out);
  const high3 = size[2];
  const oblique = turned(plus(plus([0, 0, 0], side, Math.cos(32 * RAD)), out, -Math.sin(32 * RAD)));
  const { centre, radius } = domeOf(scene);
  // the dome, seen at a tilt t, is from R above its centre to R sin t below it; of the disc before it a part is enough
  const tilt = 20;
  const sin = Math.sin(tilt * RAD);
  const all: Eye = { turn: oblique, tilt, far: far(2.2 * radius, 1.2 * radius * (1 + DISC * sin)), at: centre, isFlat: false };
  const eyes: Record<EyeName, Eye> = {
    overview: moved(all, 0, 0.5 * radius * (1 - DISC * sin)),
    facade: { turn: turned(out), tilt: 8, far: far(1.3 * along, 1.45 * high3) + deep / 2, at, isFlat: false },
    section: { turn: turned(side), tilt: 0, far: far(1.42 * deep, 1.3 * high3), at: plus(at, out, 0.12 * deep), isFlat: true },
    plan: { turn: turned(side), tilt: 90, far: far(1.25 * deep, 1.25 * along), at, isFlat: true },
    back: { turn: turned(plus([0, 0, 0], out, -1)), tilt: 6, far: far(1.2 * along, 1.3 * high3) + deep / 2, at, isFlat: false },
  };
  return rounded(eyes[name]);
}

export function rounded(eye: Eye): Eye {
  const to = (value: number, digits: number) => Number(value.toFixed(digits));
  return { turn: to(((eye.turn % 360) + 360) % 360, 1), tilt: to(Math.min(90, Math.max(-20, eye.tilt)), 1), far: to(Math.min(500, Math.max(0.5, eye.far)), 2), at: eye.at.map((one) => to(one, 2)) as Vec, isFlat: eye.isFlat };
}

/** The picture moved by as many metres to the right and up. */
export function moved(eye: Eye, right: number, up: number): Eye {
  const [turn, tilt] = [eye.turn * RAD, eye.tilt * RAD];
  const across: Vec = [-Math.cos(turn), Math.sin(turn), 0];
  const upward: Vec = [-Math.sin(turn) * Math.sin(tilt), -Math.cos(turn) * Math.sin(tilt), Math.cos(tilt)];
  return { ...eye, at: plus(plus(eye.at, across, right), upward, up) };
}

/** Metres that a pixel is across where the eye looks. */
export const metresPerPixel = (eye: Eye, high: number): number => (2 * eye.far * Math.tan(HALF_VIEW_DEG * RAD)) / Math.max(high, 1);

export function byKey(eye: Eye, event: KeyboardEvent): Eye | null {
  const step = event.shiftKey ? 0.06 * eye.far : 0;
  switch (event.key) {
    case "ArrowLeft":
      return step ? moved(eye, -step, 0) : { ...eye, turn: eye.turn + 5 };
    case "ArrowRight":
      return step ? moved(eye, step, 0) : { ...eye, turn: eye.turn - 5 };
    case "ArrowUp":
      return step ? moved(eye, 0, step) : { ...eye, tilt: eye.tilt + 4 };
    case "ArrowDown":
      return step ? moved(eye, 0, -step) : { ...eye, tilt: eye.tilt - 4 };
    case "+":
    case "=":
    case "PageUp":
      return { ...eye, far: eye.far / 1.15 };
    case "-":
    case "PageDown":
      return { ...eye, far: eye.far * 1.15 };
    default:
      return null;
  }
}

