// The page's state: one object, kept in the address so that a link reproduces it.

import { ROOM_START, type RoomState } from "./room_state";
import { hashOf, type Shape, stateOf, stateOfHash, type Tree } from "./state_text";
import { YEAR_START, type YearState } from "./year_state";

export type Scalar = string | number | boolean | null;
export type Panel = { kind: string } & Record<string, Scalar | number[]>;

export interface State {
  view: string;
  theme: string;
  panel: { a: Panel; b: Panel; compares: boolean; elevation: number; azimuth: number };
  room: RoomState;
  year: YearState;
  bsdf: { path: string; key: string; elevation: number; azimuth: number; side: string; band: string; plane: number };
}

export const START: State = {
  view: "panel",
  theme: "auto",
  panel: {
    a: { kind: "laser-cut", spacing_mm: 6, thickness_mm: 6, medium: "pmma" },
    b: { kind: "prismatic", pitch_mm: 4, lower_deg: 45, upper_deg: 80, base_mm: 3, ridges: "front", medium: "pmma" },
    compares: false,
    elevation: 45,
    azimuth: 0,
  },
  room: ROOM_START,
  year: YEAR_START,
  bsdf: { path: "", key: "", elevation: 40, azimuth: 0, side: "front", band: "visible", plane: 0 },
};

/** What is known of the state's parts besides their start; a view adds its own. */
const SHAPE: Shape = {
  start: START as unknown as Tree,
  whole: ["room.tables"],
  free: ["panel.a", "panel.b"],
};

type Listener = () => void;

let state = read(location.hash);
let written = location.hash;
let waiting = 0;
const listeners = new Set<Listener>();

export const current = (): State => state;

/** Replaces one part of the state. */
export function change<K extends keyof State>(part: K, values: State[K] extends object ? Partial<State[K]> : State[K]) {
  const old = state[part];
  state = { ...state, [part]: typeof old === "object" ? { ...old, ...(values as object) } : values } as State;
  if (!waiting) waiting = window.setTimeout(write, 200);
  listeners.forEach((listener) => listener());
}

export function follow(listener: Listener): () => void {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

/** The address that shows what the page shows now. */
export function link(): string {
  return location.href.split("#")[0] + hash(state);
}

function write() {
  waiting = 0;
  written = hash(state);
  history.replaceState(null, "", written || "#");
}

window.addEventListener("hashchange", () => {
  if (location.hash === written) return;
  state = read(location.hash);
  written = location.hash;
  listeners.forEach((listener) => listener());
});

/** Shows the state of a file instead; the browser's way back leads to the one before. */
export function open(tables: unknown) {
  if (waiting) {
    clearTimeout(waiting);
    write();
  }
  state = stateOf(tables, SHAPE) as unknown as State;
  written = hash(state);
  history.pushState(null, "", written || "#");
  listeners.forEach((listener) => listener());
}

function hash(from: State): string {
  return hashOf(from as unknown as Tree, SHAPE);
}

function read(text: string): State {
  return stateOfHash(text, SHAPE) as unknown as State;
}
