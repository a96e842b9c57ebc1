// The page's state: one object, kept in the address so that a link reproduces it.

import { BSDF_START, type BsdfState } from "../bsdf/state";
import { PANEL_START, type PanelState } from "../panel/state";
import { ROOM_START, type RoomState } from "../room/state";
import { YEAR_START, type YearState } from "../year/state";
import { hashOf, type Shape, stateOf, stateOfHash, type Tree } from "./state_text";

export type Scalar = string | number | boolean | null;
/** A number, a list that repeats, a medium of its own, a drawing: whatever a panel's file holds. */
export type Value = Scalar | Value[] | { [name: string]: Value };
export type Panel = { kind: string } & Record<string, Value>;

export interface State {
  view: string;
  theme: string;
  panel: PanelState;
  room: RoomState;
  year: YearState;
  bsdf: BsdfState;
}

export const START: State = {
  view: "panel",
  theme: "auto",
  panel: PANEL_START,
  room: ROOM_START,
  year: YEAR_START,
  bsdf: BSDF_START,
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
