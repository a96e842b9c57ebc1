// Any result of a study: opened or dropped, its variants compared, in plan, by the hour, as a table of cases.

import { useEffect, useState } from "preact/hooks";
import { useDrop } from "../parts/drop";
import { droppedFile } from "../parts/dropped_folder";
import { ask, type Fault, Refused, send } from "../server/ask";
import { change, type State } from "../state/state";
import { year as words } from "../words/year";
import type { ResultTold } from "./answers";
import { YearCases } from "./cases";
import { YearFigures } from "./figures";
import { YearHours } from "./hours";
import { YearPlans } from "./plans";
import { YearSide } from "./side";
import "./year.css";

export function YearView({ state, isDark }: { state: State; isDark: boolean }) {
  const look = state.year;
  const [told, setTold] = useState<ResultTold | null>(null);
  const [faults, setFaults] = useState<Fault[]>([]);
  const [opening, setOpening] = useState("");
  const took = (found: ResultTold, path: string) => {
    setTold(found);
    setFaults([]);
    setOpening("");
    change("year", { key: found.key, path });
  };
  const refuse = (fault: unknown, message?: string) => {
    setOpening("");
    setTold(null);
    setFaults(message ? [{ field: null, message }] : ((fault as Refused).faults ?? [{ field: null, message: String(fault) }]));
  };
  const fresh = { sensor: -1, hidden: [] as string[], of: "", minus: "", x: "", y: "", by: "", day: "", series: "mean" };
  const open = (path: string) => {
    setOpening(path);
    setFaults([]);
    ask<ResultTold>("/api/result/open", { path }).then(
      (found) => {
        if (found.path !== look.path) change("year", fresh);
        took(found, path);
      },
      (fault) => {
        change("year", { key: "", path: "" });
        refuse(fault);
      },
    );
  };
  useEffect(() => {
    if (told && told.key === look.key) return;
    if (look.path) {
      setOpening(look.path);
      ask<ResultTold>("/api/result/open", { path: look.path }).then((found) => took(found, look.path), refuse);
    } else if (look.key) ask<ResultTold>("/api/result/open", { key: look.key }).then((found) => took(found, ""), () => refuse(null, words.gone));
    else setTold(null);
  }, [look.key, look.path]);
  const drop = async (file: File | undefined) => {
    if (!file) return;
    setOpening(file.name);
    try {
      const found = await send<ResultTold>(`/api/result?name=${encodeURIComponent(file.name)}`, file);
      change("year", fresh);
      took(found, "");
    } catch (fault) {
      change("year", { key: "", path: "" });
      refuse(fault);
    }
  };
  const { isOver, hands } = useDrop((held) => void droppedFile(held).then(drop, refuse));
  /** The room of the result, at the hour that is looked at. */
  const openRoom = (file: string) => {
    const day = Math.floor((Date.parse(`${look.day}T00:00:00Z`) - Date.parse(`${look.day.slice(0, 4)}-01-01T00:00:00Z`)) / 86_400_000) + 1;
    change("room", { file, tables: {}, variant: "", ...(day > 0 ? { day, minute: Math.round(60 * look.hour) } : {}) });
    change("view", "room");
  };
  const shown = told ? told.variants.map((_, k) => k).filter((k) => !look.hidden.includes(told.variants[k])) : [];
  const turn = (name: string, on: boolean) => change("year", { hidden: on ? look.hidden.filter((one) => one !== name) : [...look.hidden, name] });
  return (
    <div class="view yearView" {...hands}>
      <aside class="side" aria-label={words.results}>
        {told && told.variants.length > 1 && (
          <fieldset class="controls">
            <legend>{words.variants}</legend>
            {told.variants.map((name) => (
              <label key={name} class="check">
                <input type="checkbox" checked={!look.hidden.includes(name)} disabled={shown.length === 1 && !look.hidden.includes(name)} onChange={(event) => turn(name, event.currentTarget.checked)} />
                {name}
              </label>
            ))}
          </fieldset>
        )}
        <YearSide path={look.path} runPath={look.run} isOver={isOver} faults={faults} onDrop={(file) => void drop(file)} onOpen={open} />
      </aside>
      <div class="main" aria-busy={opening !== ""}>
        {!told && (
          <div class="noResult">
            <p class="big">{opening ? `${opening} ${words.opening}` : words.nothingOpen}</p>
            {!opening && <p class="hint">{words.nothingHint}</p>}
          </div>
        )}
        {told && (
          <>
            <section class="figure about resultAbout">
              <div class="resultHead">
                <h2>{told.title || told.name}</h2>
                <span class="kindBadge">{words.kinds[told.kind]}</span>
                {told.source && (
                  <button onClick={() => openRoom(told.source as string)}>
                    {words.openRoom}
                  </button>
                )}
              </div>
              <p>
                {told.what}, {told.path || told.name}
                {told.source && `; ${words.fromFile.toLowerCase()} ${told.source}`}
              </p>
              <details>
                <summary>{words.provenance}</summary>
                <dl class="provenance">
                  {told.provenance.map((one) => (
                    <div key={one.label}>
                      <dt>{one.label}</dt>
                      <dd>{one.text}</dd>
                    </div>
                  ))}
                </dl>
              </details>
            </section>
            {told.figures.length > 0 && <YearFigures told={told} shown={shown} explains={look.explains} />}
            {told.metrics.length > 0 && <YearPlans told={told} shown={shown} look={look} />}
            {told.has_hours && <YearHours told={told} shown={shown} look={look} isDark={isDark} />}
            {told.variants.length === 0 && <YearCases key={told.key} told={told} look={look} />}
          </>
        )}
      </div>
    </div>
  );
}
