// The cases of a sweep, the trials of a design, the shares of a panel: any column against any other, and the table.

import { useState } from "preact/hooks";
import { DrawScatter, type Series } from "../draw/scatter";
import { written } from "../draw/written";
import { ChoiceInput, Faults } from "../parts/inputs";
import { Figure } from "../parts/save";
import { useAnswer } from "../server/follow";
import { change, type State } from "../state/state";
import { year as words } from "../words/year";
import type { Cases, Column, ResultTold } from "./answers";
import { quoted } from "./figures";

const MOST_ROWS = 400;
const MOST_SERIES = 12;

export function YearCases({ told, look }: { told: ResultTold; look: State["year"] }) {
  const [cursor, setCursor] = useState(-1);
  const answer = useAnswer<Cases>("/api/result/cases", { key: told.key });
  const cases = answer.value;
  if (!cases) return <Faults faults={answer.faults} />;
  const named = (name: string) => cases.columns.find((one) => one.name === name);
  const x = named(look.x) ?? named(cases.start.x) ?? cases.columns[0];
  const chosen = named(look.y);
  const ys = (chosen ? [chosen] : cases.start.y.map(named)).filter((one): one is Column => one !== undefined && one.is_number);
  const by = look.by === "-" ? undefined : (named(look.by) ?? named(cases.start.by));
  const words_ = x.is_number ? undefined : [...new Set(x.values.map(String))];
  const place = (row: number): number | null => {
    const value = x.values[row];
    return words_ ? words_.indexOf(String(value)) : typeof value === "number" ? value : null;
  };
  const series: Series[] = ys.flatMap((y) => {
    const groups = by && ys.length === 1 ? [...new Set(by.values.map(String))].slice(0, MOST_SERIES) : [""];
    return groups.map((group) => ({
      label: ys.length > 1 ? y.label : group ? `${by?.label} ${said1(group)} ${by?.unit ?? ""}`.trim() : y.label,
      isJoined: told.kind !== "design" && !words_ && x.role === "parameter",
      marks: Array.from({ length: cases.rows }, (_, row) => row)
        .filter((row) => !group || String(by?.values[row]) === group)
        .flatMap((row) => {
          const [across, up] = [place(row), y.values[row]];
          return across === null || typeof up !== "number" ? [] : [{ x: across, y: up, error: y.errors?.[row], row }];
        }),
    }));
  });
  const drawn = series.filter((one) => one.marks.length);
  const isFrontDrawn = (cases.front?.length ?? 0) > 1 && ys.length === 1 && cases.objectives?.length === 2 ? cases.objectives.every((one) => [x.name, ys[0].name].includes(one.figure)) : (cases.front?.length ?? 0) > 1;
  const withUnit = (one: Column) => `${one.label}${one.unit ? ` [${one.unit}]` : ""}`;
  const numbers = cases.columns.filter((one) => one.is_number);
  const failed = cases.columns.find((one) => one.name === "status")?.values.filter((one) => one === "failed").length ?? 0;
  const csvTable = () => Object.fromEntries(cases.columns.map((one) => [quoted(one.name), one.values.map((value) => (typeof value === "string" ? quoted(value) : (value ?? "")))]));
  const option = (one: Column): [string, string] => [one.name, withUnit(one)];
  return (
    <>
      <section class="figure lookBar" aria-label={words.show}>
        <ChoiceInput id="casesX" label={words.xAxis} value={x.name} options={cases.columns.filter((one) => one.role !== "note" || one.is_number).map(option)} onChange={(to) => change("year", { x: to })} />
        <ChoiceInput id="casesY" label={words.yAxis} value={chosen ? chosen.name : ys.length > 1 ? "" : (ys[0]?.name ?? "")} options={[...(ys.length > 1 || cases.start.y.length > 1 ? ([["", cases.start.y.map((name) => named(name)?.label).join(", ")]] as [string, string][]) : []), ...numbers.map(option)]} onChange={(to) => change("year", { y: to })} />
        <ChoiceInput id="casesBy" label={words.byAxis} value={by && ys.length === 1 ? by.name : "-"} options={[["-", words.noSeries], ...cases.columns.filter((one) => one.role === "parameter" || one.name === "stage").map(option)]} onChange={(to) => change("year", { by: to })} />
        {cases.objectives && cases.objectives.length > 0 && (
          <p class="hint">
            {words.objectives}: {cases.objectives.map((one) => `${named(one.figure)?.label ?? one.figure}, ${words.aims[one.aim] ?? one.aim}`).join("; ")}.
          </p>
        )}
        {cases.unbeaten && cases.unbeaten.length > 0 && <p class="hint">{words.unbeaten(cases.unbeaten.join(", "))}</p>}
        {failed > 0 && <p class="hint">{words.failedCases(failed)}</p>}
      </section>
      <Figure name="cases" title={`${ys.map((one) => one.label).join(", ")} · ${x.label}`} table={csvTable}>
        {drawn.length ? (
          <DrawScatter
            series={drawn}
            words={words_?.map((word, k): [number, string] => [k, word])}
            label={`${ys.map((one) => one.label).join(", ")}, ${words.xAxis.toLowerCase()} ${x.label}`}
            xLabel={withUnit(x)}
            yLabel={ys.length > 1 ? words.share.replace("[%]", "[0–1]") : withUnit(ys[0])}
            front={isFrontDrawn ? cases.front : []}
            frontWord={words.front}
            best={told.kind === "design" ? cases.best : null}
            bestWord={words.bestCase}
            cursor={cursor}
            onMove={setCursor}
          />
        ) : (
          <p class="hint">{words.nothingToDraw}</p>
        )}
        <p class="readout" role="status">
          {cursor >= 0 ? cases.columns.filter((one) => one.values[cursor] !== null && one.values[cursor] !== "").map((one) => `${one.label} ${typeof one.values[cursor] === "number" ? written(one.values[cursor] as number) : one.values[cursor]}${one.unit && typeof one.values[cursor] === "number" ? ` ${one.unit}` : ""}`).slice(0, 9).join(" · ") : words.rowsOf(cases.rows, cases.rows_in_all)}
        </p>
      </Figure>
      <Figure name="table" title={words.casesTitle[told.kind] ?? words.table} table={csvTable} noPicture>
        <div class="tableScroll tall" tabindex={0} role="group" aria-label={words.table}>
          <table>
            <thead>
              <tr>
                {cases.columns.map((one) => (
                  <th key={one.name} scope="col">
                    {one.label} {one.unit && <span class="unitOf">{one.unit}</span>}
                  </th>
                ))}
              </tr>
            </thead>
            <tbody>
              {Array.from({ length: Math.min(cases.rows, MOST_ROWS) }, (_, row) => (
                <tr key={row} class={[row === cursor ? "at" : "", cases.front?.includes(row) ? "onFront" : "", row === cases.best ? "best" : ""].join(" ").trim()} onMouseEnter={() => setCursor(row)}>
                  {cases.columns.map((one) => {
                    const value = one.values[row];
                    return <td key={one.name}>{typeof value === "number" ? written(value) : value}</td>;
                  })}
                </tr>
              ))}
            </tbody>
          </table>
        </div>
        <p class="hint">{words.rowsOf(Math.min(cases.rows, MOST_ROWS), cases.rows_in_all)}</p>
      </Figure>
    </>
  );
}

const said1 = (text: string): string => (text !== "" && Number.isFinite(Number(text)) ? written(Number(text)) : text);
