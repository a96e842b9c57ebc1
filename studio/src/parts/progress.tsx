// How far a job is, and the way to end it.

import type { Doing } from "../server/follow";
import { words } from "../words/page";
import { Faults } from "./inputs";

export function Progress<T>({ job, isQuiet = false }: { job: Doing<T>; isQuiet?: boolean }) {
  const isBusy = job.state === "waiting" || job.state === "running";
  return (
    <>
      {isBusy && !isQuiet && (
        <p class="progress">
          <progress value={job.share || undefined} max={1} aria-label={words.working} /> <button onClick={job.stop}>{words.stop}</button>
        </p>
      )}
      {job.state === "cancelled" && !isQuiet && (
        <p class="progress">
          {words.stopped} <button onClick={job.start}>{words.again}</button>
        </p>
      )}
      <Faults faults={job.faults} />
    </>
  );
}
