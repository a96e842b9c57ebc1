// A year that is being computed: it goes on while other views are looked at.

import { useEffect, useReducer } from "preact/hooks";
import { type Fault, type JobState, type Refused, Work } from "./ask";
import type { YearRun } from "./year_answers";

export interface Running {
  path: string;
  state: "idle" | JobState<YearRun>["state"];
  share: number;
  now: YearRun | null;
  faults: Fault[];
}

let running: Running = { path: "", state: "idle", share: 0, now: null, faults: [] };
let work: Work<YearRun> | null = null;
const listeners = new Set<() => void>();

function turn(to: Partial<Running>) {
  running = { ...running, ...to };
  listeners.forEach((listener) => listener());
}

export function startYear(path: string) {
  work?.cancel();
  turn({ path, state: "waiting", share: 0, now: null, faults: [] });
  work = new Work<YearRun>(
    { kind: "year", path },
    (job) => turn({ state: job.state, share: job.total ? job.done / job.total : 0, now: job.result ?? job.partial ?? running.now }),
    (fault: Refused) => turn({ state: "failed", faults: fault.faults ?? [] }),
  );
}

export function stopYear() {
  work?.cancel();
  turn({ state: "cancelled" });
}

export function useYearRun(): Running {
  const [, again] = useReducer((n: number) => n + 1, 0);
  useEffect(() => {
    const heard = () => again(0);
    listeners.add(heard);
    return () => {
      listeners.delete(heard);
    };
  }, []);
  return running;
}
