// The panel: its section with the beams, its shares, how they depend on the sun, two side by side.

import { useState } from "preact/hooks";
import type { Discs, Dispersion, Kinds, Lobes, Section, Table } from "./answers";
import { ask, askText, type Fault, Refused } from "./ask";
import { DrawAngular, DrawRadial, type Curve } from "./draw_angular";
import { DrawDisc } from "./draw_disc";
import { DrawDispersion } from "./draw_dispersion";
import { DrawSection } from "./draw_section";
import { DrawShares } from "./draw_shares";
import { type Doing, useAnswer, useJob, useOnce } from "./follow";
import { chosen, Faults, SliderInput } from "./inputs";
import { PanelControls } from "./panel_controls";
import { Figure, saveFile } from "./save";
import { change, type Panel, type State } from "./state";
import { words } from "./words";

const QUANTITIES = ["transmittance_deflected", "transmittance_undeflected", "reflectance"];
const RADIAL = ["transmittance", "reflectance"];

interface Looked {
  section: ReturnType<typeof useAnswer<Section>>;
  lobes: ReturnType<typeof useAnswer<Lobes>>;
  angular: Doing<Table>;
  klems: Doing<{ key: string }>;
  dispersion: Doing<Dispersion>;
  discs: ReturnType<typeof useAnswer<Discs>>;
}

function useLooked(panel: Panel, sun: State["panel"], isShown: boolean): Looked {
  const incidence = { elevation_deg: sun.elevation, azimuth_deg: sun.azimuth };
  const asked = isShown ? { panel, ...incidence } : null;
  const section = useAnswer<Section>("/api/panel/section", asked);
  const lobes = useAnswer<Lobes>("/api/panel/lobes", asked);
  const angular = useJob<Table>({ kind: "angular", panel, azimuth_deg: sun.azimuth }, isShown);
  const klems = useJob<{ key: string }>({ kind: "klems", panel }, false);
  const dispersion = useJob<Dispersion>({ kind: "dispersion", panel, ...incidence }, false);
  const key = klems.isStale ? "" : klems.value?.key;
  const discs = useAnswer<Discs>("/api/bsdf/discs", isShown && key ? { key, ...incidence } : null);
  return { section, lobes, angular, klems, dispersion, discs };
}

export function PanelView({ state, isDark }: { state: State; isDark: boolean }) {
  const sun = state.panel;
  const kinds = useOnce<Kinds>("/api/panel/kinds");
  const [fileFaults, setFileFaults] = useState<Fault[]>([]);
  const a = useLooked(sun.a, sun, true);
  const b = useLooked(sun.b, sun, sun.compares);
  const names = (sun.compares ? ["a", "b"] : ["a"]) as ("a" | "b")[];
  const looked = { a, b };
  const setSun = (elevation: number) => change("panel", { elevation: Math.round(10 * Math.min(89, Math.max(-89, elevation))) / 10 });
  const open = async (file: File | undefined) => {
    if (!file) return;
    try {
      const { panel } = await ask<{ panel: Panel }>("/api/panel/read", { text: await file.text() });
      setFileFaults([]);
      change("panel", { a: panel });
    } catch (fault) {
      setFileFaults([{ field: null, message: `${words.badFile}: ${(fault as Refused).message}` }]);
    }
  };
  const toToml = async (panel: Panel) => saveFile("panel.toml", (await ask<{ text: string }>("/api/panel/toml", { panel })).text);
  const curves: Curve[] = names.flatMap((name) => {
    const table = looked[name].angular.value;
    return table ? [{ name, table, dash: name === "a" ? "" : "6 4" }] : [];
  });
  const angularTable = () => Object.assign({}, ...curves.map(({ name, table }) => Object.fromEntries(Object.entries(table).map(([key, values]) => [curves.length > 1 && key !== "elevation_deg" ? `${name}_${key}` : key, values]))));
  return (
    <div class={`view panelView${sun.compares ? " compares" : ""}`}>
      <aside class="side" aria-label={words.panel}>
        {kinds.value &&
          names.map((name) => (
            <PanelControls
              key={name}
              name={name}
              title={sun.compares ? words.panelNames[name] : words.panel}
              panel={sun[name]}
              kinds={kinds.value as Kinds}
              faults={[...looked[name].section.faults, ...looked[name].lobes.faults].filter((fault, k, all) => all.findIndex((one) => one.message === fault.message) === k)}
              onChange={(panel) => change("panel", { [name]: panel })}
            />
          ))}
        <Faults faults={kinds.faults} />
        <fieldset class="controls">
          <legend>{words.sun}</legend>
          <SliderInput id="elevation" label={words.elevation} value={sun.elevation} low={-89} high={89} step={0.5} unit="°" onChange={setSun} />
          <SliderInput id="azimuth" label={words.azimuth} value={sun.azimuth} low={-89} high={89} step={0.5} unit="°" onChange={(azimuth) => change("panel", { azimuth: Math.min(89, Math.max(-89, azimuth)) })} />
        </fieldset>
        <label class="check">
          <input type="checkbox" checked={sun.compares} onChange={(event) => change("panel", { compares: event.currentTarget.checked })} /> {words.compare}
        </label>
        <div class="files">
          <label class="button">
            {words.openToml}
            <input type="file" accept=".toml" onChange={(event) => void open(chosen(event))} />
          </label>
          {names.map((name) => (
            <button key={name} onClick={() => void toToml(sun[name])}>
              TOML{sun.compares ? ` ${name.toUpperCase()}` : ""}
            </button>
          ))}
        </div>
        <Faults faults={fileFaults} />
      </aside>
      <div class="main">
        <div class={sun.compares ? "two" : "one"}>
          {names.map((name) => (
            <OnePanel key={name} name={name} looked={looked[name]} state={state} isDark={isDark} onSun={setSun} />
          ))}
        </div>
        <div class="grid">
          <Figure name="angular" title={words.angularTitle} table={curves.length ? angularTable : undefined}>
            {names.map((name) => (
              <Progress key={name} job={looked[name].angular} />
            ))}
            <DrawAngular curves={curves} quantities={QUANTITIES} elevation={sun.elevation} words={words.share} label={words.angularTitle} axis={words.elevation} />
          </Figure>
          <Figure name="radial" title={words.radialTitle} hint={words.radialText}>
            <DrawRadial curves={curves} quantities={RADIAL} elevation={sun.elevation} words={{ transmittance: words.goesThrough, reflectance: words.comesBack }} label={words.radialTitle} />
          </Figure>
          {names.map((name) => (
            <Klems key={name} title={`${words.klemsTitle}${sun.compares ? `: ${words.panelNames[name]}` : ""}`} looked={looked[name]} />
          ))}
          {names.map((name) => (
            <DispersionFigure key={name} title={`${words.dispersionTitle}${sun.compares ? `: ${words.panelNames[name]}` : ""}`} job={looked[name].dispersion} />
          ))}
        </div>
      </div>
    </div>
  );
}

function OnePanel({ name, looked, state, isDark, onSun }: { name: "a" | "b"; looked: Looked; state: State; isDark: boolean; onSun: (elevation: number) => void }) {
  const { section, lobes } = looked;
  const shares = lobes.value?.shares ?? null;
  const title = state.panel.compares ? words.panelNames[name] : words.section;
  const beams = lobes.value?.lobes.filter((lobe) => lobe.power >= 5e-4) ?? [];
  const table = () => ({
    power: lobes.value?.lobes.map((lobe) => lobe.power) ?? [],
    side: lobes.value?.lobes.map((lobe) => lobe.side) ?? [],
    elevation_deg: lobes.value?.lobes.map((lobe) => lobe.elevation_deg) ?? [],
    azimuth_deg: lobes.value?.lobes.map((lobe) => lobe.azimuth_deg) ?? [],
  });
  return (
    <div class="onePanel" data-panel={name}>
      <Figure name={`section-${name}`} title={title} table={table}>
        <DrawSection
          section={section.value}
          elevation={state.panel.elevation}
          isDark={isDark}
          isStale={section.faults.length > 0}
          label={words.sectionText(state.panel.elevation, shares?.transmittance ?? 0, shares?.transmittance_deflected ?? 0)}
          sunLabel={words.dragSun}
          outside={words.outside}
          room={words.room}
          onSun={onSun}
        />
      </Figure>
      <div class="numbers" aria-live="off">
        {Object.entries(words.symbols).map(([key, symbol]) => (
          <div key={key}>
            <b data-number={key} data-value={shares?.[key] ?? ""}>
              {shares ? `${(100 * shares[key]).toFixed(1)} %` : "…"}
            </b>
            <span>{symbol}</span>
          </div>
        ))}
      </div>
      <DrawShares shares={shares} words={words.share} label={words.shares} isStale={lobes.faults.length > 0} />
      <details>
        <summary>{words.beams}</summary>
        <table>
          <thead>
            <tr>
              {words.beamHeads.map((head) => (
                <th key={head} scope="col">
                  {head}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {beams.slice(0, 40).map((beam, k) => (
              <tr key={k}>
                <td>{(100 * beam.power).toFixed(2)} %</td>
                <td>{beam.side === "back" ? words.room : words.outside}</td>
                <td>{beam.elevation_deg.toFixed(2)}°</td>
                <td>{beam.azimuth_deg.toFixed(2)}°</td>
                <td>{beam.total_reflections}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </details>
    </div>
  );
}

export function Progress<T>({ job }: { job: Doing<T> }) {
  const isBusy = job.state === "waiting" || job.state === "running";
  return (
    <>
      {isBusy && (
        <p class="progress">
          <progress value={job.share || undefined} max={1} aria-label={words.working} /> <button onClick={job.stop}>{words.stop}</button>
        </p>
      )}
      {job.state === "cancelled" && (
        <p class="progress">
          {words.stopped} <button onClick={job.start}>{words.again}</button>
        </p>
      )}
      <Faults faults={job.faults} />
    </>
  );
}

function Klems({ title, looked }: { title: string; looked: Looked }) {
  const { klems, discs } = looked;
  const key = klems.isStale ? "" : klems.value?.key;
  const most = Math.max(...(discs.value?.outgoing.flatMap((one) => one.values) ?? []), 1e-9);
  const xml = async () => key && saveFile("panel.xml", await askText("/api/bsdf/xml", { key }), "application/xml");
  return (
    <Figure name="klems" title={title} hint={words.klemsHint} extra={key ? [{ label: "XML", save: () => void xml() }] : []}>
      <Progress job={klems} />
      {!key && klems.state !== "waiting" && klems.state !== "running" && klems.state !== "cancelled" && <button onClick={klems.start}>{words.again}</button>}
      {key && discs.value && (
        <div class="discs" data-key={key}>
          {discs.value.outgoing.map((one) => (
            <DrawDisc
              key={one.word}
              title={`${words.leavesAlong(one.word)}, ${(100 * one.share).toFixed(1)} %`}
              label={`${words.leavesAlong(one.word)}. ${words.discHelp}`}
              cells={one.cells}
              values={one.values}
              isLogarithmic={true}
              least={most * 1e-4}
              most={most}
              unit={words.perSteradian}
              up={words.up}
              right={words.right}
              nothing={words.noLight}
              point={discs.value?.point}
            />
          ))}
        </div>
      )}
    </Figure>
  );
}

function DispersionFigure({ title, job }: { title: string; job: Doing<Dispersion> }) {
  const data = job.isStale ? null : job.value;
  const table = () => ({
    wavelength_nm: data?.beams.map((beam) => beam.wavelength_nm) ?? [],
    elevation_deg: data?.beams.map((beam) => beam.elevation_deg) ?? [],
    power: data?.beams.map((beam) => beam.power) ?? [],
    side: data?.beams.map((beam) => beam.side) ?? [],
  });
  return (
    <Figure name="dispersion" title={title} hint={words.dispersionHint} table={data ? table : undefined}>
      <Progress job={job} />
      {!data && job.state !== "waiting" && job.state !== "running" && job.state !== "cancelled" && <button onClick={job.start}>{words.again}</button>}
      {data && <DrawDispersion data={data} axis={words.leavesAt} across={words.wavelength} label={title} nothing={words.noBeams} />}
    </Figure>
  );
}

