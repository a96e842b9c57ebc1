// The tables of a room's file: values read and written by their place, glazings of window parts chosen.

import type { Fault } from "../server/ask";
import type { Panel } from "../state/state";
import type { RoomSlider, Tables } from "./answers";

type Path = (string | number)[];

export function valueAt(tables: unknown, path: Path): unknown {
  return path.reduce<unknown>((place, name) => (place !== null && typeof place === "object" ? (place as Record<string | number, unknown>)[name] : undefined), tables);
}

/** The same tables with one value in place of another. */
export function withValue(tables: Tables, path: Path, value: unknown): Tables {
  const put = (place: unknown, rest: Path): unknown => {
    if (!rest.length) return value;
    const [name, ...others] = rest;
    if (Array.isArray(place)) return place.map((one, k) => (k === name ? put(one, others) : one));
    const table = (place ?? {}) as Tables;
    return { ...table, [name]: put(table[name], others) };
  };
  return put(tables, path) as Tables;
}

/** Places of the glazing names of windows in the tables, by the window's name. */
export function glazingPlaces(tables: Tables): Map<string, Path> {
  const found = new Map<string, Path>();
  const rows = (value: unknown): Tables[] => (Array.isArray(value) ? value : []);
  rows(valueAt(tables, ["shoebox", "opening"])).forEach((opening, k) => {
    const name = typeof opening.name === "string" ? opening.name : "window";
    const parts = rows(opening.part);
    if (!parts.length) found.set(name, ["shoebox", "opening", k, "glazing"]);
    parts.forEach((_, part) => found.set(parts.length === 1 ? name : `${name} ${part + 1}`, ["shoebox", "opening", k, "part", part, "glazing"]));
  });
  rows(tables.window).forEach((window, k) => typeof window.name === "string" && found.set(window.name, ["window", k, "glazing"]));
  return found;
}

function variantPlace(tables: Tables, variant: string): Path | null {
  const rows = Array.isArray(tables.variant) ? (tables.variant as Tables[]) : [];
  const at = rows.findIndex((one) => one.name === variant);
  return at < 0 ? null : ["variant", at, "glazing"];
}

/** The name of a window part's glazing, in a variant or as the room stands. */
export function glazingOf(tables: Tables, variant: string, window: string): string | null {
  const place = variantPlace(tables, variant);
  const others = place ? (valueAt(tables, place) as Tables | undefined) : undefined;
  if (others && typeof others[window] === "string") return others[window] as string;
  const own = glazingPlaces(tables).get(window);
  const name = own && valueAt(tables, own);
  return typeof name === "string" ? name : null;
}

/** The tables with another glazing in a window part; glazings that it needs are added. */
export function withGlazing(tables: Tables, variant: string, window: string, name: string, added: Record<string, Tables>): Tables {
  const glazings = { ...((tables.glazings as Tables) ?? {}), ...added };
  const place = variantPlace(tables, variant);
  const held = { ...tables, glazings };
  if (place) return withValue(held, [...place, window], name);
  const own = glazingPlaces(tables).get(window);
  return own ? withValue(held, own, name) : held;
}

/** The table of a panel as a room's file holds it. */
export const panelTable = (panel: Panel): Tables => ({ ...panel });

/** What stands in place of the file's tables, if anything does. */
export function changes(file: Tables, tables: Tables): Tables {
  return Object.fromEntries(Object.entries(tables).filter(([name, value]) => JSON.stringify(file[name]) !== JSON.stringify(value)));
}

/** A fault with the slider it is about as its field, where its words tell: "[table] of the room: name must …". */
export function placed(fault: Fault, sliders: RoomSlider[]): Fault {
  const said = /\[\[?(\w+)\]?\].*?: (\w+) must/.exec(fault.message);
  const isBeyond = /^window .* must lie within its wall/.test(fault.message);
  const isParts = /heights of the parts/.test(fault.message);
  const found = sliders.find(({ path, name }) => {
    const table = path.filter((one) => typeof one === "string").at(-2);
    if (isBeyond) return table === "opening" && name === "width_m";
    if (isParts) return table === "part";
    return said !== null && table === said[1] && name === said[2];
  });
  return found ? { ...fault, field: found.path.join(".") } : fault;
}
