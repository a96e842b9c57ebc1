// Questions to the server: one at a time each, the newest alone; and jobs that are followed as they go.

import { keepFile, keptFile } from "./kept_files";

export interface Fault {
  field: string | null;
  message: string;
}

export class Refused extends Error {
  constructor(readonly faults: Fault[]) {
    super(faults.map((fault) => fault.message).join("; "));
  }
}

export async function ask<T>(path: string, body: unknown = {}): Promise<T> {
  return (await posted(path, body)).json();
}

export async function askText(path: string, body: unknown): Promise<string> {
  return (await posted(path, body)).text();
}

export async function askBlob(path: string, body: unknown): Promise<Blob> {
  return (await posted(path, body)).blob();
}

export async function get<T>(path: string): Promise<T> {
  return (await asked(path, { method: "GET" })).json();
}

/** Gives the studio a file, which is kept under the key of the answer. */
export async function send<T extends { key: string }>(path: string, file: Blob): Promise<T> {
  const found: T = await (await asked(path, { method: "POST", body: file })).json();
  void keepFile(found.key, path, file);
  return found;
}

async function posted(path: string, body: unknown): Promise<Response> {
  const how = { method: "POST", body: JSON.stringify(body), headers: { "content-type": "application/json" } };
  try {
    return await asked(path, how);
  } catch (fault) {
    const key = (body as { key?: unknown }).key;
    const isUnknown = (fault as Refused).faults?.[0]?.field === "key" && typeof key === "string";
    if (!isUnknown || !(await givenBack(key))) throw fault;
    return asked(path, how);
  }
}

const giving = new Map<string, Promise<boolean>>();

/** Gives the studio a file again that it does not know any more, once for all questions that wait for it. */
function givenBack(key: string): Promise<boolean> {
  const now = giving.get(key) ?? giveBack(key).finally(() => giving.delete(key));
  giving.set(key, now);
  return now;
}

async function giveBack(key: string): Promise<boolean> {
  const kept = await keptFile(key);
  if (!kept) return false;
  return asked(kept.path, { method: "POST", body: kept.file }).then(
    () => true,
    () => false,
  );
}

/** How often the studio has come back after it was gone. */
let timesBack = 0;
let isGone = false;
const watching = new Set<() => void>();

export const back = {
  times: () => timesBack,
  follow: (heard: () => void) => {
    watching.add(heard);
    return () => void watching.delete(heard);
  },
};

/** Looks for a studio that did not answer until it does again: what it held is then asked for anew. */
async function look() {
  if (isGone) return;
  isGone = true;
  for (;;) {
    await new Promise((done) => setTimeout(done, 1000));
    try {
      if ((await fetch("/api/about", { method: "POST", body: "{}" })).ok) break;
    } catch {
      continue;
    }
  }
  isGone = false;
  timesBack += 1;
  watching.forEach((heard) => heard());
}

async function asked(path: string, how: RequestInit): Promise<Response> {
  let answer: Response;
  try {
    answer = await fetch(path, how);
  } catch {
    void look();
    throw new Refused([{ field: null, message: "offline" }]);
  }
  if (answer.ok) return answer;
  let faults: Fault[];
  try {
    faults = (await answer.json()).errors;
  } catch {
    faults = [{ field: null, message: `${answer.status} ${answer.statusText}` }];
  }
  throw new Refused(faults);
}

/** Asks the newest question only: while one is on its way, all but the last of those that come are dropped. */
export class Channel<T> {
  private busy = false;
  private next: [string, unknown] | null = null;
  private isOpen = true;

  constructor(
    private readonly got: (answer: T, body: unknown) => void,
    private readonly failed: (fault: Refused) => void,
  ) {}

  put(path: string, body: unknown) {
    this.next = [path, body];
    if (!this.busy) void this.run();
  }

  close() {
    this.isOpen = false;
    this.next = null;
  }

  private async run() {
    this.busy = true;
    while (this.next && this.isOpen) {
      const [path, body] = this.next;
      this.next = null;
      try {
        const answer = await ask<T>(path, body);
        if (this.isOpen) this.got(answer, body);
      } catch (fault) {
        if (this.isOpen) this.failed(fault as Refused);
        // a server that is gone may come back: the same question is asked again unless a newer one has come
        if (this.isOpen && !this.next && (fault as Refused).faults?.[0]?.message === "offline") {
          await new Promise((done) => setTimeout(done, 1000));
          this.next ??= [path, body];
        }
      }
    }
    this.busy = false;
  }
}

export interface JobState<T> {
  job: string;
  state: "waiting" | "running" | "done" | "failed" | "cancelled";
  done: number;
  total: number;
  partial: T | null;
  result: T | null;
  errors: Fault[];
}

/** A job that is started, or found, followed and, once nobody wants it, cancelled. */
export class Work<T> {
  private key = "";
  private source: EventSource | null = null;
  private wanted = true;

  constructor(
    body: Record<string, unknown>,
    private readonly heard: (state: JobState<T>) => void,
    private readonly failed: (fault: Refused) => void,
    found: Promise<JobState<T> | null> = Promise.resolve(null),
  ) {
    void this.start(body, found);
  }

  private async start(body: Record<string, unknown>, found: Promise<JobState<T> | null>) {
    try {
      const first = (await found) ?? (await ask<JobState<T>>("/api/jobs", body));
      this.key = first.job;
      if (!this.wanted) return this.end();
      this.heard(first);
      this.source = new EventSource(`/api/jobs/${this.key}/events`);
      this.source.onmessage = (event) => {
        const state = JSON.parse(event.data) as JobState<T>;
        if (state.state === "done" || state.state === "failed" || state.state === "cancelled") this.source?.close();
        if (!this.wanted) return;
        if (state.state === "failed") this.failed(new Refused(state.errors));
        this.heard(state);
      };
      this.source.onerror = () => {
        void look();
        if (this.source?.readyState === EventSource.CLOSED && this.wanted) this.failed(new Refused([{ field: null, message: "offline" }]));
      };
    } catch (fault) {
      if (this.wanted) this.failed(fault as Refused);
    }
  }

  cancel() {
    this.wanted = false;
    this.end();
  }

  private end() {
    this.source?.close();
    if (this.key) void fetch(`/api/jobs/${this.key}`, { method: "DELETE" }).catch(() => undefined);
  }
}
