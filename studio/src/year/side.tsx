// The results of the folder, a place to drop one, and a year to run.

import { useEffect, useState } from "preact/hooks";
import { ChoiceInput, chosen, Faults } from "../parts/inputs";
import { ask, type Fault, Refused } from "../server/ask";
import { change } from "../state/state";
import { year as words } from "../words/year";
import type { Listed, Results } from "./answers";
import { findYear, knowYear, startYear, stopYear, useYearRun } from "./run";

interface Props {
  path: string;
  runPath: string;
  isOver: boolean;
  faults: Fault[];
  onDrop: (file: File | undefined) => void;
  onOpen: (path: string) => void;
}

export function YearSide({ path, runPath, isOver, faults, onDrop, onOpen }: Props) {
  const [found, setFound] = useState<Results | null>(null);
  const [wrong, setWrong] = useState<Fault[]>([]);
  const run = useYearRun();
  const look = () => {
    ask<Results>("/api/result/files").then(
      (results) => {
        setFound(results);
        setWrong([]);
      },
      (fault: Refused) => setWrong(fault.faults ?? []),
    );
  };
  useEffect(() => {
    look();
    void findYear(runPath).then((path) => path && change("year", { run: path }));
  }, []);
  useEffect(() => {
    if (!run.isNews || !run.now?.path) return;
    knowYear();
    look();
    onOpen(run.now.path);
  }, [run.isNews]);
  const years = found?.years ?? [];
  const chosenYear = years.find((one) => one.path === runPath)?.path ?? years[0]?.path ?? "";
  const isRunning = run.state === "waiting" || run.state === "running";
  return (
    <>
      <label class={`dropPlace${isOver ? " over" : ""}`}>
        {words.drop}
        <small>{words.dropKinds}</small>
        <input type="file" accept=".nc,.csv,.json,.zip" onChange={(event) => onDrop(chosen(event))} />
      </label>
      <Faults faults={faults} />
      <fieldset class="controls">
        <legend>{words.results}</legend>
        {!found && !wrong.length && (
          <p class="hint" role="status">
            {words.looking}
          </p>
        )}
        {found && found.results.length === 0 && <p class="hint">{words.noResults}</p>}
        <ul class="resultList">
          {found?.results.map((one) => (
            <li key={one.path}>
              <button class="result" aria-current={one.path === path ? "true" : undefined} onClick={() => onOpen(one.path)}>
                <span class="kindBadge">{words.kinds[one.kind] ?? one.kind}</span>
                <b>{titleOf(one)}</b>
                <small>{[one.detail, one.date].filter(Boolean).join(" · ")}</small>
                <small class="path">{one.path}</small>
              </button>
            </li>
          ))}
        </ul>
        {found && (
          <button class="quiet" onClick={look}>
            {words.lookAgain}
          </button>
        )}
        <Faults faults={wrong} />
      </fieldset>
      {years.length > 0 && (
        <fieldset class="controls runYear">
          <legend>{words.run}</legend>
          <ChoiceInput id="yearFile" label={words.runFile} value={chosenYear} options={years.map((one): [string, string] => [one.path, one.title ? `${one.title} (${one.path})` : one.path])} onChange={(to) => change("year", { run: to })} />
          <div class="runRow">
            {isRunning ? <button onClick={stopYear}>{words.stop}</button> : <button onClick={() => startYear(chosenYear)}>{words.start}</button>}
            {isRunning && <progress max={1} value={run.share} aria-label={words.run} />}
            {isRunning && <span class="hint">{Math.floor(100 * run.share)} %</span>}
          </div>
          <p class="hint" role="status" data-state={run.state}>
            {saidOf(run.state, run.now)}
          </p>
          <Faults faults={run.faults} />
          <p class="hint">{words.runHint}</p>
        </fieldset>
      )}
    </>
  );
}

function titleOf(one: Listed): string {
  return one.title || one.path.split("/").slice(-2)[0] || one.path;
}

function saidOf(state: string, now: { variant: string; what: string; seconds_left: number | null } | null): string {
  if (state === "waiting") return words.waiting;
  if (state === "cancelled") return words.stopped;
  if (state === "failed" && now) return words.unfinished;
  if (state === "done") return words.done;
  if (state !== "running" || !now) return "";
  if (now.what === "report") return words.report;
  const left = now.seconds_left === null ? "" : ` · ${words.left(now.seconds_left)}`;
  return `${now.variant}: ${now.what}${left}`;
}
