// Plans of a quantity for all variants, their difference, and the section from the window to the back.

import { useState } from "preact/hooks";
import { DrawLines } from "../draw/lines";
import { DrawPlans } from "../draw/plans";
import { written, writtenWith } from "../draw/written";
import { DataTable } from "../parts/data_table";
import { ChoiceInput, Faults } from "../parts/inputs";
import { Figure } from "../parts/save";
import { useAnswer } from "../server/follow";
import { change, type State } from "../state/state";
import { year as words } from "../words/year";
import type { Plan, ResultTold, SectionCurves } from "./answers";
import { quoted } from "./figures";

export function YearPlans({ told, shown, look }: { told: ResultTold; shown: number[]; look: State["year"] }) {
  const [cursor, setCursor] = useState(-1);
  const metric = told.metrics.some((one) => one.key === look.metric) ? look.metric : told.metrics[0]?.key;
  const grids = told.planes.filter((one) => one.is_grid);
  const plane = grids.some((one) => one.name === look.plane) ? look.plane : grids[0]?.name;
  const isDifference = told.variants.includes(look.of) && told.variants.includes(look.minus) && look.of !== look.minus;
  const asked = metric && plane ? { key: told.key, metric, plane } : null;
  const all = useAnswer<Plan>("/api/result/plan", asked);
  const change_ = useAnswer<Plan>("/api/result/difference", asked && isDifference ? { ...asked, variant: look.of, minus: look.minus } : null);
  const section = useAnswer<SectionCurves>("/api/result/section", asked);
  if (!metric) return null;
  const answer = isDifference ? change_ : all;
  const plan = answer.value && !isDifference ? { ...answer.value, variants: answer.value.variants.filter((_, k) => shown.includes(k)) } : answer.value;
  const lines = (section.value?.variants ?? []).flatMap((one, k) => (shown.includes(k) ? [{ label: one.label, values: one.mean, low: one.least, high: one.most, errors: one.error }] : []));
  const unit = plan?.unit ?? "";
  const named = plan ? `${plan.label}${isDifference ? `: ${words.lessThan(look.of, look.minus)}` : ""}` : "";
  const picked = plan ? plan.sensors.indexOf(look.sensor) : -1;
  const other = told.variants.find((one) => one !== told.variants[0]) ?? "";
  return (
    <>
      <section class="figure lookBar" aria-label={words.show}>
        <ChoiceInput id="metric" label={words.metric} value={metric} options={told.metrics.map((one) => [one.key, one.label])} onChange={(to) => change("year", { metric: to })} />
        {grids.length > 1 && <ChoiceInput id="plane" label={words.plane} value={plane} options={grids.map((one) => [one.name, `${one.name} (${one.count})`])} onChange={(to) => change("year", { plane: to })} />}
        {told.variants.length > 1 && (
          <ChoiceInput
            id="planView"
            label={words.view}
            value={isDifference ? "difference" : "side"}
            options={[
              ["side", words.sideBySide],
              ["difference", words.difference],
            ]}
            onChange={(to) => change("year", to === "difference" ? { of: other, minus: told.variants[0] } : { of: "", minus: "" })}
          />
        )}
        {isDifference && (
          <>
            <ChoiceInput id="of" label={words.differenceOf} value={look.of} options={told.variants.map((one) => [one, one])} onChange={(to) => change("year", { of: to })} />
            <ChoiceInput id="minus" label={words.minus} value={look.minus} options={told.variants.map((one) => [one, one])} onChange={(to) => change("year", { minus: to })} />
          </>
        )}
        <p class="hint">{told.metrics.find((one) => one.key === metric)?.about}</p>
      </section>
      {!plane && <p class="hint">{words.noGrid}</p>}
      <Faults faults={answer.faults} />
      <div class="plansGrid">
        {plan && (
          <Figure
            name={`plan-${metric.replace(/[^\w]+/g, "-")}`}
            title={named}
            hint={`${isDifference ? words.differenceHint : told.has_hours ? words.plansHint : words.plansHintRoom}${!isDifference && plan.level !== null ? ` ${words.contour(writtenWith(plan.level, unit))}` : ""}`}
            table={() => planTable(plan)}
          >
            <div class={answer.isStale ? "stale" : ""}>
              <DrawPlans
                plan={plan}
                label={`${named}. ${told.has_hours ? words.plansHint : words.plansHintRoom} ${plan.variants.map((one) => `${one.label}: ${words.ends} ${written(one.least, unit)}, ${written(one.mean, unit)}, ${written(one.most, unit)} ${unit}`).join("; ")}`}
                scaleLabel={unit || "–"}
                windowWord={words.window}
                isDifference={isDifference}
                cursor={cursor}
                picked={told.has_hours && look.sensor >= 0 ? picked : -1}
                onMove={setCursor}
                onPick={told.has_hours ? (cell) => change("year", { sensor: plan.sensors[cell] ?? -1, series: "sensor" }) : undefined}
              />
            </div>
            <p class="readout" role="status">
              {cursor >= 0 && cursor < plan.sensors.length ? readout(plan, cursor) : plan.variants.length ? `${words.ends}, ${unit || "–"}` : ""}
            </p>
            <DataTable summary={words.asTable} table={() => planTable(plan)} />
          </Figure>
        )}
        {section.value && lines.length > 0 && (
          <Figure name={`section-${metric.replace(/[^\w]+/g, "-")}`} title={`${section.value.label}: ${words.section.toLowerCase()}`} hint={words.sectionHint} table={() => sectionTable(section.value as SectionCurves)}>
            <DrawLines
              x={section.value.distance_m}
              lines={lines}
              label={`${section.value.label}. ${words.section}.`}
              xLabel={words.distance}
              yLabel={`${section.value.label} [${section.value.unit || "–"}]`}
              unit={section.value.unit}
              level={section.value.level}
              isLogarithmic={section.value.is_logarithmic}
              width={430}
              height={400}
              high={section.value.unit === "%" && !section.value.is_logarithmic && Math.max(...lines.flatMap((line) => line.high.map((one) => one ?? 0))) > 60 ? 102 : undefined}
            />
            <DataTable summary={words.asTable} table={() => sectionTable(section.value as SectionCurves)} />
          </Figure>
        )}
      </div>
    </>
  );
}

export function readout(plan: Plan, cell: number): string {
  const [x, y] = [plan.x[cell % plan.x.length], plan.y[Math.floor(cell / plan.x.length)]];
  const values = plan.variants.map((one) => `${one.label}: ${writtenWith(one.values[cell], plan.unit, one.errors?.[cell])}`);
  return `${words.place(x.toFixed(2), y.toFixed(2))} · ${values.join(" · ")}`;
}

export function planTable(plan: Plan): Record<string, (number | string)[]> {
  const cells = plan.sensors.flatMap((sensor, cell) => (sensor === null ? [] : [cell]));
  const table: Record<string, (number | string)[]> = {
    x_m: cells.map((cell) => plan.x[cell % plan.x.length]),
    y_m: cells.map((cell) => plan.y[Math.floor(cell / plan.x.length)]),
  };
  for (const one of plan.variants) {
    const name = quoted(`${one.label}${plan.unit ? ` [${plan.unit}]` : ""}`);
    table[name] = cells.map((cell) => one.values[cell] ?? "");
    if (one.errors) table[quoted(`${one.label}, standard error`)] = cells.map((cell) => one.errors?.[cell] ?? "");
  }
  return table;
}

function sectionTable(section: SectionCurves): Record<string, (number | string)[]> {
  const table: Record<string, (number | string)[]> = { distance_m: section.distance_m };
  for (const one of section.variants)
    for (const name of ["mean", "least", "most"] as const) table[quoted(`${one.label}, ${name}`)] = one[name].map((value) => value ?? "");
  return table;
}
