// A year that is being computed: it goes on while other views are looked at.

import { useEffect, useReducer } from "preact/hooks";
import { type Fault, type JobState, type Refused, Work } from "../server/ask";
import { isOpen, jobs, type ListedJob } from "../server/job_list";
import type { YearRun } from "./answers";

export interface Running {
  path: string;
  state: "idle" | JobState<YearRun>["state"];
  share: number;
  now: YearRun | null;
  faults: Fault[];
  /** Whether it was done while one looked, and its result is not open yet. */
  isNews: boolean;
}

let running: Running = { path: "", state: "idle", share: 0, now: null, faults: [], isNews: false };
let work: Work<YearRun> | null = null;
const listeners = new Set<() => void>();

function turn(to: Partial<Running>) {
  running = { ...running, ...to };
  listeners.forEach((listener) => listener());
}

export function startYear(path: string, found: ListedJob<YearRun> | null = null) {
  work?.cancel();
  turn({ path, state: "waiting", share: 0, now: null, faults: [] });
  work = new Work<YearRun>(
    { kind: "year", path },
    (job) => turn({ state: job.state, share: job.total ? job.done / job.total : 0, now: job.result ?? job.partial ?? running.now, isNews: job.state === "done" }),
    (fault: Refused) => turn({ state: "failed", faults: fault.faults ?? [] }),
    Promise.resolve(found),
  );
}

/** After the page was loaded again: goes on with the year that runs, that of the file rather than another; or tells how the last one ended. */
export async function findYear(path: string): Promise<string | null> {
  const years = await jobs<YearRun>("year").catch(() => []);
  if (running.state !== "idle") return null;
  const open = years.filter(isOpen);
  const found = open.find((one) => one.asked.path === path) ?? open[0];
  if (found) startYear(String(found.asked.path), found);
  else if (years.length) turn({ path: String(years[0].asked.path), state: years[0].state, now: years[0].result, faults: years[0].errors });
  return found ? String(found.asked.path) : null;
}

/** The result of the year that was done is open now. */
export const knowYear = () => turn({ isNews: false });

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
