// Jobs that the studio does already: a page that was loaded again finds its own among them.

import { get, type JobState } from "./ask";

export interface ListedJob<T> extends JobState<T> {
  kind: string;
  asked: Record<string, unknown>;
  followers: number;
}

export const isOpen = (job: JobState<unknown>) => job.state === "waiting" || job.state === "running";

/** Those of a kind, or all: the newest first. */
export async function jobs<T>(kind = ""): Promise<ListedJob<T>[]> {
  return (await get<{ jobs: ListedJob<T>[] }>(`/api/jobs${kind && `?kind=${kind}`}`)).jobs;
}

/** Jobs of the time before this page, which nobody follows: what is started later has its page. */
let orphans: Promise<ListedJob<unknown>[]> | null = null;

/** The job that was asked the same before the page was loaded again, if it goes on and no other page follows it. */
export async function orphan<T>(body: Record<string, unknown>): Promise<JobState<T> | null> {
  orphans ??= jobs().then(
    (all) => all.filter((one) => isOpen(one) && !one.followers),
    () => [],
  );
  const left = await orphans;
  const at = left.findIndex((one) => isSame(body, one.asked));
  if (at < 0) return null;
  const [found] = left.splice(at, 1);
  const now = await get<JobState<T>>(`/api/jobs/${found.job}`).catch(() => null);
  return now && isOpen(now) ? now : null;
}

/** What was left out has its default in the list. */
function isSame(body: Record<string, unknown>, asked: Record<string, unknown>): boolean {
  return Object.entries(body).every(([name, value]) => value === undefined || value === null || JSON.stringify(value) === JSON.stringify(asked[name]));
}
