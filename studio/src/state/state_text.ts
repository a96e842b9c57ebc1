// The state as text: what an address holds, and back from whatever an address or a file holds.

export type Tree = { [name: string]: unknown };

/** What a state may hold besides what it starts with. */
export interface Shape {
  start: Tree;
  /** Tables that stand in the address as one, whatever is in them. */
  whole: string[];
  /** Tables with a `kind` and any names: one that is told is told wholly. */
  free: string[];
}

/** Longest text and list that a state holds: no real one comes near. */
const LONGEST_TEXT = 4000;
const LONGEST_LIST = 1000;

const isTable = (value: unknown): value is Tree => value !== null && typeof value === "object" && !Array.isArray(value);

/** The state as the part of an address behind #: what differs from the start. */
export function hashOf(state: Tree, shape: Shape): string {
  const start = flat(shape.start, shape);
  const said = Object.entries(flat(state, shape))
    .filter(([name, value]) => name.endsWith(".kind") || start[name] !== value)
    .map(([name, value]) => `${encodeURIComponent(name)}=${encodeURIComponent(value).replace(/%2C/g, ",")}`);
  return said.length ? `#${said.join("&")}` : "";
}

/** The state that an address holds; what cannot be read is as at the start. */
export function stateOfHash(hash: string, shape: Shape): Tree {
  const told: Tree = {};
  for (const part of hash.replace(/^#/, "").split("&")) {
    const cut = part.indexOf("=");
    if (cut < 1) continue;
    try {
      put(told, decodeURIComponent(part.slice(0, cut)).split("."), JSON.parse(decodeURIComponent(part.slice(cut + 1))));
    } catch {
      continue;
    }
  }
  // an address says of a panel what differs from the one of the same kind that the page starts with
  for (const path of shape.free) {
    const [own, start] = [at(told, path), at(shape.start, path)];
    if (isTable(own) && isTable(start) && (own.kind === undefined || own.kind === start.kind)) put(told, path.split("."), { ...start, ...own });
  }
  return stateOf(told, shape);
}

/** The state that tables hold: of what it starts with each value of the same type, and what may be told besides. */
export function stateOf(told: unknown, shape: Shape): Tree {
  return taken(told, shape.start, "", shape) as Tree;
}

function taken(told: unknown, start: unknown, path: string, shape: Shape): unknown {
  if (shape.free.includes(path)) return isTable(told) && typeof told.kind === "string" ? plain(told) : structuredClone(start);
  if (shape.whole.includes(path)) return isTable(told) ? plain(told) : structuredClone(start);
  if (isTable(start)) {
    const own = isTable(told) ? told : {};
    return Object.fromEntries(Object.entries(start).map(([name, value]) => [name, taken(Object.hasOwn(own, name) ? own[name] : undefined, value, path ? `${path}.${name}` : name, shape)]));
  }
  if (Array.isArray(start)) return isList(told, start) ? [...told] : [...start];
  if (typeof told !== typeof start) return start;
  if (typeof told === "number") return Number.isFinite(told) ? told : start;
  return typeof told === "string" && told.length > LONGEST_TEXT ? start : told;
}

/** Whether it is a list of plain values of one type, that of the start's if it has any. */
function isList(told: unknown, start: unknown[]): told is unknown[] {
  if (!Array.isArray(told) || told.length > LONGEST_LIST) return false;
  const type = typeof (start[0] ?? told[0]);
  return told.every((one) => typeof one === type && ["string", "number", "boolean"].includes(type) && !(typeof one === "number" && !Number.isFinite(one)));
}

/** A table without the names that JavaScript keeps for itself. */
function plain(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(plain);
  if (!isTable(value)) return value;
  return Object.fromEntries(Object.entries(value).flatMap(([name, one]) => (name === "__proto__" || one === null ? [] : [[name, plain(one)]])));
}

function flat(tree: Tree, shape: Shape, before = ""): Record<string, string> {
  const found: Record<string, string> = {};
  for (const [name, value] of Object.entries(tree)) {
    const path = before + name;
    const isFree = shape.free.includes(before.slice(0, -1));
    if (isTable(value) && !isFree && !shape.whole.includes(path)) Object.assign(found, flat(value, shape, `${path}.`));
    else if (value !== undefined) found[path] = JSON.stringify(value);
  }
  return found;
}

function at(tree: Tree, path: string): unknown {
  return path.split(".").reduce<unknown>((place, name) => (isTable(place) && Object.hasOwn(place, name) ? place[name] : undefined), tree);
}

function put(tree: Tree, names: string[], value: unknown) {
  let place = tree;
  for (const name of names.slice(0, -1)) {
    if (name === "__proto__") return;
    if (!Object.hasOwn(place, name) || !isTable(place[name])) place[name] = {};
    place = place[name] as Tree;
  }
  const last = names[names.length - 1];
  if (last !== "__proto__") place[last] = value;
}
