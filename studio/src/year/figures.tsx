// What the variants come down to: a table with the best marked, and shares as dots.

import { categoryOf, markOf } from "../draw/colours";
import { DrawDots } from "../draw/dots";
import { Figure } from "../parts/save";
import { change } from "../state/state";
import { year as words } from "../words/year";
import type { ResultTold } from "./answers";

export function YearFigures({ told, shown, explains }: { told: ResultTold; shown: number[]; explains: boolean }) {
  const names = shown.map((k) => told.variants[k]);
  const rows = told.figures.filter((row) => row.cells.some((cell) => cell.value !== null));
  const dots = rows.filter((row) => row.is_share).map((row) => ({ label: row.name === "lighting_saved_percent" ? words.electricitySaved : row.label.replace(/, mean$/, ""), dots: shown.map((k) => row.cells[k]) }));
  const table = () => ({
    figure: rows.flatMap((row) => shown.map(() => quoted(row.label))),
    unit: rows.flatMap((row) => shown.map(() => row.unit)),
    variant: rows.flatMap(() => names.map(quoted)),
    value: rows.flatMap((row) => shown.map((k) => row.cells[k].value ?? "")),
    standard_error: rows.flatMap((row) => shown.map((k) => row.cells[k].error ?? "")),
  });
  return (
    <div class={dots.length || told.glazings.length ? "grid figuresGrid" : ""}>
      <Figure name="figures" title={words.figures} hint={names.length > 1 ? words.figuresHint : undefined} table={table} noPicture>
        <div class="tableScroll" tabindex={0} role="group" aria-label={words.figures}>
          <table class="figures">
            <thead>
              <tr>
                <th scope="col">
                  <span class="srOnly">{words.figures}</span>
                </th>
                {names.map((name) => (
                  <th key={name} scope="col">
                    {name}
                  </th>
                ))}
              </tr>
            </thead>
            <tbody>
              {rows.map((row) => (
                <tr key={row.name} data-figure={row.name}>
                  <th scope="row" title={row.about}>
                    {row.label} {row.unit && <span class="unitOf">{row.unit}</span>}
                    {explains ? <small>{row.about}</small> : <span class="srOnly">{row.about}</span>}
                  </th>
                  {shown.map((k) => {
                    const isBest = names.length > 1 && row.best.includes(k);
                    return (
                      <td key={k} class={isBest ? "best" : ""} data-value={row.cells[k].value ?? ""}>
                        {isBest && (
                          <span class="bestMark" role="img" aria-label={words.best}>
                            ●
                          </span>
                        )}
                        {row.cells[k].text}
                      </td>
                    );
                  })}
                </tr>
              ))}
            </tbody>
          </table>
        </div>
        <label class="check">
          <input type="checkbox" checked={explains} onChange={(event) => change("year", { explains: event.currentTarget.checked })} />
          {words.explain}
        </label>
      </Figure>
      <div class="chartStack">
      {dots.length > 0 && (
        <Figure name="comparison" title={words.comparison} table={table}>
          <DrawDots rows={dots} names={names} axis={words.share} label={`${words.comparison}: ${dots.map((row) => `${row.label} ${row.dots.map((dot, k) => `${names[k]} ${dot.text}`).join(", ")}`).join("; ")}`} />
        </Figure>
      )}
      {told.glazings.length > 0 && (
        <section class="figure glazings" aria-label={words.whatIsCompared}>
          <h3>{words.whatIsCompared}</h3>
          <dl>
            {shown.map((k, number) => (
              <div key={told.variants[k]}>
                <dt>
                  <svg viewBox="-7 -7 14 14" aria-hidden="true">
                    <path class="seriesMark" fill={categoryOf(number)} d={markOf(number)} />
                  </svg>
                  {told.variants[k]}
                </dt>
                {told.glazings[k]?.map((text) => (
                  <dd key={text}>{text}</dd>
                ))}
              </div>
            ))}
          </dl>
        </section>
      )}
      </div>
    </div>
  );
}

export const quoted = (text: string): string => (/[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text);
