// Views follow the state, answers and jobs.

import { useEffect, useLayoutEffect, useReducer, useRef, useState } from "preact/hooks";
import { current, follow, type State } from "../state/state";
import { ask, back, Channel, type Fault, type JobState, Refused, Work } from "./ask";
import { orphan } from "./job_list";

export function useStudio(): State {
  const [, turn] = useReducer((n: number) => n + 1, 0);
  useEffect(() => follow(() => turn(0)), []);
  return current();
}

/** How often the studio has come back: a view of then is to be made anew. */
export function useTimesBack(): number {
  const [times, setTimes] = useState(back.times());
  useEffect(() => back.follow(() => setTimes(back.times())), []);
  return times;
}

export interface Answer<T> {
  value: T | null;
  faults: Fault[];
  isStale: boolean;
}

/** The answer to the newest question; while it is on its way, the last one. Asked again when `again` changes. */
export function useAnswer<T>(path: string, body: unknown, again?: unknown): Answer<T> {
  const [answer, setAnswer] = useState<Answer<T>>({ value: null, faults: [], isStale: true });
  const channel = useRef<Channel<T> | null>(null);
  const text = body === null ? "" : JSON.stringify(body);
  useLayoutEffect(() => {
    const made = new Channel<T>(
      (value) => setAnswer({ value, faults: [], isStale: false }),
      (fault) => setAnswer((old) => ({ value: old.value, faults: fault.faults ?? [], isStale: true })),
    );
    channel.current = made;
    return () => made.close();
  }, []);
  // before the frame that shows the change, not after it
  useLayoutEffect(() => {
    if (text) channel.current?.put(path, JSON.parse(text));
    else setAnswer({ value: null, faults: [], isStale: false });
  }, [path, text, again]);
  return answer;
}

/** What is asked once. */
export function useOnce<T>(path: string): Answer<T> {
  const [answer, setAnswer] = useState<Answer<T>>({ value: null, faults: [], isStale: true });
  useEffect(() => {
    ask<T>(path).then(
      (value) => setAnswer({ value, faults: [], isStale: false }),
      (fault: Refused) => setAnswer({ value: null, faults: fault.faults ?? [], isStale: true }),
    );
  }, [path]);
  return answer;
}

export interface Doing<T> extends Answer<T> {
  state: "idle" | JobState<T>["state"];
  share: number;
  start: () => void;
  stop: () => void;
}

/**
 * A job for the newest question: the old one is cancelled as soon as another is asked. One that was asked the same before
 * the page was loaded again is gone on with; `isFound`: also where jobs of this kind are started by hand.
 */
export function useJob<T>(body: Record<string, unknown>, isAutomatic: boolean, isFound = false): Doing<T> {
  const work = useRef<Work<T> | null>(null);
  const [found, setFound] = useState<{ value: T | null; text: string; faults: Fault[]; state: Doing<T>["state"]; share: number }>({
    value: null,
    text: "",
    faults: [],
    state: "idle",
    share: 0,
  });
  const text = JSON.stringify(body);
  const begin = (before: Promise<JobState<T> | null>) => {
    work.current?.cancel();
    setFound((old) => ({ ...old, faults: [], state: "waiting", share: 0 }));
    work.current = new Work<T>(
      JSON.parse(text),
      (job) =>
        setFound((old) => {
          const value = job.result ?? job.partial;
          const share = job.total ? job.done / job.total : 0;
          return value ? { value, text, faults: [], state: job.state, share } : { ...old, state: job.state, share };
        }),
      (fault) => setFound((old) => ({ ...old, faults: fault.faults ?? [], state: "failed" })),
      before,
    );
  };
  const start = () => begin(orphan<T>(JSON.parse(text)));
  const stop = () => {
    work.current?.cancel();
    setFound((old) => ({ ...old, state: "cancelled" }));
  };
  useEffect(() => {
    if (!isAutomatic) {
      work.current?.cancel();
      setFound((old) => (old.state === "waiting" || old.state === "running" ? { ...old, state: "cancelled" } : old));
      return;
    }
    const later = setTimeout(start, 350);
    return () => clearTimeout(later);
  }, [text, isAutomatic]);
  useEffect(() => {
    if (isFound) void orphan<T>(JSON.parse(text)).then((before) => before && begin(Promise.resolve(before)));
    return () => work.current?.cancel();
  }, []);
  return { ...found, isStale: found.text !== text, start, stop };
}

export function useIsDark(theme: string): boolean {
  const query = useRef(matchMedia("(prefers-color-scheme: dark)"));
  const [system, setSystem] = useState(query.current.matches);
  useEffect(() => {
    const heard = (event: MediaQueryListEvent) => setSystem(event.matches);
    query.current.addEventListener("change", heard);
    return () => query.current.removeEventListener("change", heard);
  }, []);
  return theme === "auto" ? system : theme === "dark";
}
