// A BSDF that is open: by its file in the folder, by what was dropped, or by its key in a link.

import { useEffect, useState } from "preact/hooks";
import type { BsdfTold } from "../server/answers";
import { ask, type Fault, Refused, send } from "../server/ask";
import { change } from "../state/state";
import { words } from "../words/page";
import type { BsdfState } from "./state";

export type Slot = "a" | "b";

export interface Opened {
  told: BsdfTold | null;
  key: string;
  faults: Fault[];
  isReading: boolean;
  choose: (path: string) => void;
  drop: (file: File | undefined) => Promise<void>;
}

/** The first or the second BSDF of the view. */
export function useOpened(slot: Slot, look: BsdfState): Opened {
  const [told, setTold] = useState<BsdfTold | null>(null);
  const [faults, setFaults] = useState<Fault[]>([]);
  const [isReading, setIsReading] = useState(false);
  const isFirst = slot === "a";
  const [path, key] = isFirst ? [look.path, look.key] : [look.otherPath, look.otherKey];
  const put = (path: string, key: string) => change("bsdf", isFirst ? { path, key } : { otherPath: path, otherKey: key });
  const took = (found: BsdfTold, path: string) => {
    setTold(found);
    setFaults([]);
    setIsReading(false);
    put(path, found.key);
    const bands = Object.keys(found.bands);
    if (isFirst && !bands.includes(look.band)) change("bsdf", { band: bands[0] });
  };
  const refuse = (fault: unknown) => {
    setIsReading(false);
    setFaults((fault as Refused).faults ?? [{ field: null, message: String(fault) }]);
  };
  useEffect(() => {
    if (told && told.key === key) return;
    if (!key && !path) return;
    setIsReading(true);
    ask<BsdfTold>("/api/bsdf/open", path ? { path } : { key }).then(
      (found) => took(found, path),
      (fault) => refuse(path ? fault : { faults: [{ field: null, message: words.gone }] }),
    );
  }, [key, path]);
  const drop = async (file: File | undefined) => {
    if (!file) return;
    setIsReading(true);
    try {
      took(await send<BsdfTold>(`/api/bsdf?name=${encodeURIComponent(file.name)}`, file), "");
    } catch (fault) {
      setTold(null);
      put("", "");
      refuse(fault);
    }
  };
  const isOpen = told !== null && told.key === key;
  return { told: isOpen ? told : null, key: isOpen ? key : "", faults, isReading, choose: (path) => path && put(path, ""), drop };
}
