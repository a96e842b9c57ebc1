// The numbers of a plane with their errors, and how far the work has got.

import { unsure, written } from "../draw/written";
import { Faults } from "../parts/inputs";
import type { Fault } from "../server/ask";
import type { Doing } from "../server/follow";
import { words } from "../words/page";
import { room as said } from "../words/room";
import type { RoomLight, RoomWork } from "./answers";

export interface Told {
  values: number[];
  errors: number[] | null;
  mean: number;
  least: number;
  most: number;
  uniformity: number | null;
  meanError: number | null;
  uniformityError: number | null;
}

export function RoomNumbers({ told, unit, light, isStale }: { told: Told | null; unit: string; light: RoomLight | null; isStale: boolean }) {
  const errorAt = (value: number): number | null => (told?.errors ? (told.errors[told.values.indexOf(value)] ?? null) : null);
  const cards: [string, string, number | undefined, number | null, string][] = [
    ["mean", said.mean, told?.mean, told?.meanError ?? null, unit],
    ["least", said.least, told?.least, told ? errorAt(told.least) : null, unit],
    ["most", said.most, told?.most, told ? errorAt(told.most) : null, unit],
    ["uniformity", said.uniformity, told?.uniformity ?? undefined, told?.uniformityError ?? null, ""],
    ["diffuse", said.outsideDiffuse, light?.outside.diffuse_horizontal_lx, null, "lx"],
    ["direct", said.outsideDirect, light?.outside.direct_normal_lx, null, "lx"],
  ];
  return (
    <div class={`numbers roomNumbers${isStale ? " stale" : ""}`} aria-live="off">
      {cards.map(([name, label, value, error, of]) => (
        <div key={name}>
          <b data-number={name} data-value={value ?? ""}>
            {value === undefined ? "…" : unsure(value, error).value}
            <small>
              {value !== undefined && error ? ` ± ${unsure(value, error).error}` : ""} {of}
            </small>
          </b>
          <span>{label}</span>
        </div>
      ))}
    </div>
  );
}

/** Whether the light that is shown holds all that was asked for: the sun's own as well. */
const holdsAll = (work: Doing<RoomWork>, sunWork: Doing<RoomWork>, light: RoomLight | null) =>
  work.state === "done" && light !== null && (light.outside.direct_normal_lx === 0 || (sunWork.state === "done" && !sunWork.isStale && light.sun_rounds === sunWork.value?.rounds));

export function RoomProgress({ work, sunWork, light, target, known }: { work: Doing<RoomWork>; sunWork: Doing<RoomWork>; light: RoomLight | null; target: number; known: Fault[] }) {
  const isBusy = work.state === "waiting" || work.state === "running";
  const now = work.isStale ? null : work.value;
  const error = now ? 100 * now.worst_relative_error : null;
  // the error falls with the root of the work
  const share = now ? Math.min(1, (target / Math.max(now.worst_relative_error, 1e-9)) ** 2) : 0;
  return (
    <div class="progress roomProgress" data-rounds={now?.rounds ?? 0} data-error={now?.worst_relative_error ?? ""} data-state={work.state} data-whole={holdsAll(work, sunWork, light)}>
      {(isBusy || now) && <progress value={now ? (now.converged ? 1 : share) : undefined} max={1} aria-label={words.working} />}
      <span>
        {now && error !== null ? said.round(now.rounds, written(error)) : isBusy ? said.first : ""}
        {now ? `, ${isBusy ? said.refining : now.converged ? said.reached : said.stoppedAt}` : ""}
      </span>
      {isBusy && <button onClick={work.stop}>{said.stop}</button>}
      {!isBusy && work.state !== "idle" && !(now?.converged ?? false) && <button onClick={work.start}>{said.goOn}</button>}
      <Faults faults={work.faults.filter((fault) => !known.some((other) => other.message === fault.message))} />
    </div>
  );
}
