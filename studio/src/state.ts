// The page's state: one object, kept in the address so that a link reproduces it.

import { ROOM_START, type RoomState } from "./room_state";

export type Scalar = string | number | boolean | null;
export type Panel = { kind: string } & Record<string, Scalar | number[]>;

export interface State {
  view: string;
  theme: string;
  panel: { a: Panel; b: Panel; compares: boolean; elevation: number; azimuth: number };
  room: RoomState;
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
  bsdf: { path: "", key: "", elevation: 40, azimuth: 0, side: "front", band: "visible", plane: 0 },
};

/** Parts that stand in the address as one, whatever is in them. */
const WHOLE = ["room.tables"];

type Tree = { [name: string]: unknown };
type Listener = () => void;

let state: State = read(location.hash);
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

function hash(from: State): string {
  const start = flat(START as unknown as Tree);
  const said = Object.entries(flat(from as unknown as Tree))
    .filter(([name, value]) => name.endsWith(".kind") || start[name] !== value)
    .map(([name, value]) => `${encodeURIComponent(name)}=${encodeURIComponent(value).replace(/%2C/g, ",")}`);
  return said.length ? `#${said.join("&")}` : "";
}

function flat(tree: Tree, before = ""): Record<string, string> {
  const found: Record<string, string> = {};
  for (const [name, value] of Object.entries(tree)) {
    if (value !== null && typeof value === "object" && !Array.isArray(value) && !WHOLE.includes(before + name)) Object.assign(found, flat(value as Tree, `${before}${name}.`));
    else found[before + name] = JSON.stringify(value);
  }
  return found;
}

function read(text: string): State {
  const made = structuredClone(START) as unknown as Tree;
  const pairs: [string[], unknown][] = [];
  for (const part of text.replace(/^#/, "").split("&")) {
    const [name, value] = part.split("=");
    if (!name || value === undefined) continue;
    try {
      pairs.push([decodeURIComponent(name).split("."), JSON.parse(decodeURIComponent(value))]);
    } catch {
      continue;
    }
  }
  // a panel that is told is told wholly: nothing of the one it starts with is left of another kind
  for (const [path, value] of pairs)
    if (path[0] === "panel" && path[2] === "kind") {
      const panels = made.panel as Record<string, Panel>;
      if (path[1] in panels && panels[path[1]].kind !== value) panels[path[1]] = { kind: String(value) };
    }
  for (const [path, value] of pairs) {
    let place = made;
    for (const name of path.slice(0, -1)) {
      if (!Object.hasOwn(place, name) || typeof place[name] !== "object") break;
      place = place[name] as Tree;
    }
    const name = path[path.length - 1];
    const isPanel = path[0] === "panel" && path.length === 3;
    if (name !== "__proto__" && (isPanel || (Object.hasOwn(place, name) && typeof place[name] === typeof value))) place[name] = value;
  }
  return made as unknown as State;
}
