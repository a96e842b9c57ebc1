// The hours of a year: carpets of all variants, one hour in plan, one day, and the months.

import { useMemo, useState } from "preact/hooks";
import { DrawCarpet } from "../draw/carpet";
import { DrawLines } from "../draw/lines";
import { DrawPlans } from "../draw/plans";
import { writtenWith } from "../draw/written";
import { DataTable } from "../parts/data_table";
import { ChoiceInput, Faults } from "../parts/inputs";
import { Figure } from "../parts/save";
import { useAnswer } from "../server/follow";
import { change, type State } from "../state/state";
import { year as words } from "../words/year";
import type { Carpet, HourPlan, Months, Numbers, ResultTold } from "./answers";
import { quoted } from "./figures";
import { planTable, readout } from "./plans";

interface Props {
  told: ResultTold;
  shown: number[];
  look: State["year"];
  isDark: boolean;
}

export function YearHours({ told, shown, look, isDark }: Props) {
  const [cursor, setCursor] = useState<[number, number] | null>(null);
  const [cell, setCell] = useState(-1);
  // another result may have fewer sensors
  const sensor = look.sensor < told.planes.reduce((sum, one) => sum + one.count, 0) ? look.sensor : -1;
  const series = look.series === "sensor" && sensor < 0 ? "mean" : look.series in words.seriesNames ? look.series : "mean";
  const asked = { key: told.key, series, ...(series === "sensor" ? { sensor } : {}) };
  const answer = useAnswer<Carpet>("/api/result/carpet", asked);
  const months = useAnswer<Months>("/api/result/months", asked);
  const whole = answer.value;
  const carpet = useMemo(() => whole && { ...whole, variants: whole.variants.filter((_, k) => shown.includes(k)) }, [whole, shown.join()]);
  const row = whole ? Math.min(Math.max(Math.floor(look.hour / whole.step_h), 0), whole.rows - 1) : 12;
  const day = whole ? Math.max(whole.days.indexOf(look.day), -1) : -1;
  const start = whole && day < 0 ? brightest(whole) : day;
  const picked: [number, number] | null = whole ? [start, day < 0 ? Math.floor(12 / whole.step_h) : row] : null;
  const at = whole && picked ? { day: whole.days[picked[0]], hour: (picked[1] + 0.5) * whole.step_h } : null;
  const grids = told.planes.filter((one) => one.is_grid);
  const hour = useAnswer<HourPlan>("/api/result/hour", at && grids.length ? { key: told.key, ...at, ...(grids.some((one) => one.name === look.plane) ? { plane: look.plane } : {}) } : null);
  const plan = hour.value && { ...hour.value, variants: hour.value.variants.filter((_, k) => shown.includes(k)) };
  const pick = ([to, up]: [number, number]) => whole && change("year", { day: whole.days[to], hour: (up + 0.5) * whole.step_h });
  const options = Object.entries(words.seriesNames).filter(([name]) => name !== "sensor" || sensor >= 0) as [string, string][];
  const followed = series === "sensor" && plan ? plan.sensors.indexOf(sensor) : -1;
  const about = plan && followed >= 0 ? words.place(plan.x[followed % plan.x.length].toFixed(2), plan.y[Math.floor(followed / plan.x.length)].toFixed(2)) : words.seriesNames[series];
  const carpetTable = () => {
    const table: Record<string, (number | string)[]> = { day: [], hour: [], in_use: [] };
    if (!carpet) return table;
    for (const one of carpet.variants) table[quoted(`${one.label} [lx]`)] = [];
    carpet.days.forEach((name, d) => {
      for (let r = 0; r < carpet.rows; r++) {
        table.day.push(name);
        table.hour.push(r * carpet.step_h);
        table.in_use.push(carpet.in_use[r * carpet.days.length + d] ?? "");
        for (const one of carpet.variants) table[quoted(`${one.label} [lx]`)].push(one.values[r * carpet.days.length + d] ?? "");
      }
    });
    return table;
  };
  const hours = carpet ? Array.from({ length: carpet.rows }, (_, r) => (r + 0.5) * carpet.step_h) : [];
  const ofDay = carpet && picked ? carpet.variants.map((one) => ({ label: one.label, values: hours.map((_, r) => one.values[r * carpet.days.length + picked[0]]) })) : [];
  const dayTable = () => Object.assign({ hour: hours }, ...ofDay.map((one) => ({ [quoted(`${one.label} [lx]`)]: one.values.map((value) => value ?? "") })));
  const used = (months.value?.variants ?? []).flatMap((one, k) => (shown.includes(k) ? [{ label: one.label, values: look.onlyUse ? one.in_use : one.daylit }] : []));
  const monthTable = () =>
    Object.assign(
      { month: months.value?.months ?? [] },
      ...(months.value?.variants ?? []).map((one) => ({ [quoted(`${one.label}, hours of use [lx]`)]: one.in_use.map((value) => value ?? ""), [quoted(`${one.label}, daylight [lx]`)]: one.daylit.map((value) => value ?? "") })),
    );
  return (
    <>
      <section class="figure lookBar" aria-label={words.hours}>
        <ChoiceInput id="series" label={words.series} value={series} options={options} onChange={(to) => change("year", { series: to })} />
        <label class="check">
          <input type="checkbox" checked={look.onlyUse} onChange={(event) => change("year", { onlyUse: event.currentTarget.checked })} />
          {words.onlyUse}
        </label>
        {sensor < 0 && <p class="hint">{words.pickFirst}</p>}
      </section>
      <Faults faults={answer.faults} />
      {carpet && (
        <Figure name="carpets" title={`${words.hours}: ${about}`} hint={words.hoursHint} table={carpetTable}>
          <div class={answer.isStale ? "stale" : ""}>
            <DrawCarpet
              carpet={carpet}
              label={`${words.hours}: ${about}. ${words.hoursHint}`}
              months={words.months}
              hourWord={words.hour}
              onlyUse={look.onlyUse}
              isDark={isDark}
              cursor={cursor}
              picked={picked}
              onMove={setCursor}
              onPick={pick}
            />
          </div>
          <p class="readout" role="status">
            {cursor || picked ? saidOf(carpet, cursor ?? (picked as [number, number])) : ""}
          </p>
        </Figure>
      )}
      <div class="grid">
        {plan && (
          <Figure name="hour" title={words.oneHour(timeSaid(plan.time))} hint={skySaid(plan, shown, told)} table={() => planTable(plan)}>
            <div class={hour.isStale ? "stale" : ""}>
              <DrawPlans plan={plan} label={`${words.oneHour(timeSaid(plan.time))}. ${words.illuminance}.`} scaleLabel="lx" windowWord={words.window} cursor={cell} picked={plan.sensors.indexOf(sensor)} most={620} onMove={setCell} onPick={(to) => change("year", { sensor: plan.sensors[to] ?? -1, series: "sensor" })} />
            </div>
            <p class="readout" role="status">
              {cell >= 0 && cell < plan.sensors.length ? readout(plan, cell) : `${words.ends}, lx`}
            </p>
            <DataTable summary={words.asTable} table={() => planTable(plan)} />
          </Figure>
        )}
        <Faults faults={hour.faults} />
        {carpet && picked && (
            <Figure name="day" title={words.oneDay(daySaid(carpet.days[picked[0]]))} hint={about[0].toUpperCase() + about.slice(1)} table={dayTable}>
              <DrawLines
                x={hours}
                lines={ofDay}
                label={`${words.oneDay(daySaid(carpet.days[picked[0]]))}: ${about}`}
                xLabel={words.hourAxis}
                yLabel={`${words.illuminance} [lx]`}
                unit="lx"
                level={300}
                xTicks={[0, 3, 6, 9, 12, 15, 18, 21, 24].filter((tick) => tick <= hours[hours.length - 1] && tick >= hours[0]).map((tick) => [tick, String(tick)])}
                here={hours[picked[1]]}
                shading={spansOfUse(carpet, picked[0], hours)}
                onPick={(r) => pick([picked[0], r])}
                height={400}
              />
              <DataTable summary={words.asTable} table={dayTable} />
            </Figure>
        )}
      </div>
      {months.value && months.value.months.length > 1 && (
            <Figure name="months" title={words.monthsTitle} hint={look.onlyUse ? words.monthsUse : words.monthsAll} table={monthTable}>
              <DrawLines
                x={months.value.months.map((_, k) => k)}
                lines={used}
                label={words.monthsTitle}
                xLabel={words.month}
                yLabel={`${words.illuminance} [lx]`}
                unit="lx"
                xTicks={months.value.months.map((month, k): [number, string] => [k, words.months[Number(month.slice(5, 7)) - 1]])}
                width={1000}
                height={270}
              />
              <DataTable summary={words.asTable} table={monthTable} />
            </Figure>
          )}
    </>
  );
}

/** The day that is shown first: the brightest of those in use. */
function brightest(carpet: Carpet): number {
  let [best, most] = [Math.floor(carpet.days.length / 2), 0];
  carpet.days.forEach((_, k) => {
    let sum = 0;
    for (let r = 0; r < carpet.rows; r++) if (carpet.in_use[r * carpet.days.length + k]) sum += carpet.variants[0]?.values[r * carpet.days.length + k] ?? 0;
    if (sum > most) [best, most] = [k, sum];
  });
  return best;
}

function daySaid(day: string): string {
  const date = new Date(`${day}T12:00:00Z`);
  return `${words.weekdays[date.getUTCDay()]} ${date.getUTCDate()} ${words.months[date.getUTCMonth()]}`;
}

function timeSaid(time: string): string {
  return `${daySaid(time.slice(0, 10))}, ${time.slice(11)}`;
}

function saidOf(carpet: Carpet, [day, row]: [number, number]): string {
  const place = row * carpet.days.length + day;
  const clock = (hour: number) => `${String(Math.floor(hour)).padStart(2, "0")}:${String(Math.round((hour % 1) * 60)).padStart(2, "0")}`;
  const values = carpet.variants.map((one) => {
    const light = one.values[place] === 0 ? words.night : writtenWith(one.values[place], "lx");
    return `${one.label}: ${light}${one.blinds?.[place] ? ` (${words.blindsClosed})` : ""}`;
  });
  const use = carpet.in_use[place] ? words.inUse : words.notInUse;
  return `${daySaid(carpet.days[day])}, ${clock(row * carpet.step_h)}–${clock((row + 1) * carpet.step_h)}, ${use} · ${values.join(" · ")}`;
}

function skySaid(plan: HourPlan, shown: number[], told: ResultTold): string {
  const sun = plan.sun ? words.sunAt(plan.sun.altitude_deg, plan.sun.azimuth_deg) : "";
  const closed = shown.map((k) => told.variants[k]).filter((name) => plan.blinds_closed[name]?.length);
  const blinds = Object.keys(plan.blinds_closed).length ? (closed.length ? words.blindsOf(closed.map((name) => `${name} (${plan.blinds_closed[name].join(", ")})`).join("; ")) : words.blindsOpen) : "";
  return [sun, plan.in_use ? `${words.inUse[0].toUpperCase()}${words.inUse.slice(1)}.` : `${words.notInUse[0].toUpperCase()}${words.notInUse.slice(1)}.`, blinds].filter(Boolean).join(" ");
}

/** Spans of a day in which the room is in use, as places on the axis of hours. */
function spansOfUse(carpet: Carpet, day: number, hours: number[]): [number, number][] {
  const spans: [number, number][] = [];
  const isUsed = (r: number) => (carpet.in_use as Numbers)[r * carpet.days.length + day] === 1;
  for (let r = 0; r < carpet.rows; r++) {
    if (!isUsed(r)) continue;
    const begin = r;
    while (r + 1 < carpet.rows && isUsed(r + 1)) r++;
    const half = carpet.step_h / 2;
    spans.push([Math.max(hours[begin] - half, hours[0]), Math.min(hours[r] + half, hours[hours.length - 1])]);
  }
  return spans;
}
