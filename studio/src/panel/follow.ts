// A panel's answers: at once while something is dragged, sharper once it rests, refined by a job where only rays can.

import { useLayoutEffect, useRef, useState } from "preact/hooks";
import type { Discs, Dispersion, KlemsTold, Lobes, Section, Table, Walked } from "../server/answers";
import { Channel, type Fault } from "../server/ask";
import { type Answer, type Doing, useAnswer, useJob } from "../server/follow";
import type { Panel } from "../state/state";
import type { PanelState } from "./state";

/** Milliseconds without a change after which the full answer is asked for. */
const RESTS = 180;
const MOST_LOBES = 400;

export interface Looked {
  section: Answer<Section>;
  lobes: Answer<Lobes> & { isCoarse: boolean };
  walk: Doing<Walked>;
  angular: Doing<Table>;
  klems: Doing<KlemsTold>;
  dispersion: Doing<Dispersion>;
  discs: Answer<Discs>;
}

export function useLooked(panel: Panel, sun: PanelState, isShown: boolean, follows: boolean): Looked {
  const incidence = { elevation_deg: sun.elevation, azimuth_deg: sun.azimuth, side: sun.side };
  const section = useAnswer<Section>("/api/panel/section", isShown ? { panel, ...incidence } : null);
  const lobes = useSharpened(isShown ? { panel, ...incidence } : null);
  const isRough = isShown && lobes.value?.is_smooth === false && lobes.faults.length === 0;
  const walk = useJob<Walked>({ kind: "walk", panel, ...incidence }, isRough);
  const angular = useJob<Table>({ kind: "angular", panel, azimuth_deg: sun.azimuth, side: sun.side }, isShown && lobes.faults.length === 0);
  const klems = useJob<KlemsTold>({ kind: "klems", panel, basis: sun.basis, accuracy: sun.accuracy }, false, true);
  const dispersion = useJob<Dispersion>({ kind: "dispersion", panel, ...incidence }, follows && isShown && lobes.faults.length === 0);
  const key = klems.isStale ? "" : klems.value?.key;
  const discs = useAnswer<Discs>("/api/bsdf/discs", isShown && key ? { key, ...incidence, band: sun.band } : null);
  return { section, lobes, walk, angular, klems, dispersion, discs };
}

/** The quick answer of every question, and the full one of those that rest. */
function useSharpened(asked: Record<string, unknown> | null): Answer<Lobes> & { isCoarse: boolean } {
  const [found, setFound] = useState<Answer<Lobes> & { isCoarse: boolean }>({ value: null, faults: [], isStale: true, isCoarse: true });
  const channels = useRef<{ quick: Channel<Lobes>; full: Channel<Lobes> } | null>(null);
  const newest = useRef("");
  const timer = useRef(0);
  const text = asked === null ? "" : JSON.stringify(asked);
  useLayoutEffect(() => {
    const wrong = (fault: { faults?: Fault[] }) => setFound((old) => ({ ...old, faults: fault.faults ?? [], isStale: true }));
    const isNewest = (body: unknown) => (body as { asked: string }).asked === newest.current;
    const full = new Channel<Lobes>((value, body) => isNewest(strip(body)) && setFound({ value, faults: [], isStale: false, isCoarse: false }), wrong);
    const quick = new Channel<Lobes>((value, body) => {
      setFound({ value, faults: [], isStale: false, isCoarse: !value.is_full && value.is_smooth });
      const now = strip(body);
      if (value.is_full || !value.is_smooth || !isNewest(now)) return;
      clearTimeout(timer.current);
      timer.current = window.setTimeout(() => isNewest(now) && full.put("/api/panel/lobes", { ...(JSON.parse(now.asked) as object), detail: "full", most: MOST_LOBES }), RESTS);
    }, wrong);
    channels.current = { quick, full };
    return () => {
      quick.close();
      full.close();
      clearTimeout(timer.current);
    };
  }, []);
  useLayoutEffect(() => {
    newest.current = text;
    clearTimeout(timer.current);
    if (text) channels.current?.quick.put("/api/panel/lobes", { ...(JSON.parse(text) as object), detail: "quick", most: MOST_LOBES });
    else setFound({ value: null, faults: [], isStale: false, isCoarse: true });
  }, [text]);
  return found;
}

/** The question of a body without how finely it was asked. */
function strip(body: unknown): { asked: string } {
  const { detail: _, most: __, ...rest } = body as Record<string, unknown>;
  return { asked: JSON.stringify(rest) };
}
