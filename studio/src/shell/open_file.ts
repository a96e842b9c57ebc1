// Files that are opened without saying what they are: the server tells what a TOML is, the ending what else there is.

import { ask, Refused, send } from "../server/ask";
import { change, current, open, type Panel } from "../state/state";
import { words } from "../words/page";

interface Opened {
  kind: "page" | "panel" | "room" | "year" | "sweep" | "design";
  view: string | null;
  tables: Record<string, unknown>;
  path: string | null;
  tells: string | null;
}

/** Opens a file in the view that it is for; what there is to say about it, and whether it was opened. */
export async function openFile(file: File): Promise<{ text: string; isWrong: boolean }> {
  try {
    const ending = file.name.toLowerCase().split(".").pop() ?? "";
    const tells = ending === "toml" ? await openToml(await file.text()) : await openOther(file, ending);
    return { text: tells ?? words.opened(file.name), isWrong: false };
  } catch (fault) {
    const message = fault instanceof Refused ? fault.message : String(fault);
    return { text: `${words.badFile}: ${message === "offline" ? words.offline : message}`, isWrong: true };
  }
}

async function openToml(text: string): Promise<string | null> {
  const { kind, view, tables, tells } = await ask<Opened>("/api/open", { text });
  if (kind === "page") open(tables);
  else if (view) {
    if (kind === "panel") change("panel", { a: tables as Panel });
    else change("room", { file: "", tables, variant: "" });
    change("view", view);
  }
  return tells;
}

async function openOther(file: File, ending: string): Promise<null> {
  const name = encodeURIComponent(file.name);
  if (ending === "xml") {
    const { key } = await send<{ key: string }>(`/api/bsdf?name=${name}`, file);
    change("bsdf", { key, path: "" });
    change("view", "bsdf");
  } else {
    const { key } = await send<{ key: string }>(`/api/result?name=${name}`, file);
    change("year", { key, path: "" });
    change("view", "year");
  }
  return null;
}

/** The whole state of the page as the text of a file. */
export async function pageToml(): Promise<string> {
  return (await ask<{ text: string }>("/api/page/toml", { state: current() })).text;
}
