// The panel's curves: shares against elevation, the radial diagram, dispersion.

import { useState } from "preact/hooks";
import { DrawAngular, type Curve } from "../draw/angular";
import { DrawDispersion } from "../draw/dispersion";
import { DrawGoes, DrawRadial } from "../draw/radial";
import { ChoiceInput } from "../parts/inputs";
import { Progress } from "../parts/progress";
import { Figure } from "../parts/save";
import { change, type State } from "../state/state";
import { words } from "../words/page";
import { panel as said } from "../words/panel";
import type { Looked } from "./follow";
import { beamTable } from "./one";

const QUANTITIES = ["transmittance_deflected", "transmittance_undeflected", "reflectance"];
const RADIAL = ["transmittance", "reflectance"];
type Names = ("a" | "b")[];
type Both = { a: Looked; b: Looked };

const titled = (title: string, name: "a" | "b", names: Names): string => (names.length > 1 ? `${title}: ${words.panelNames[name]}` : title);

export function CurveFigures({ names, looked, state }: { names: Names; looked: Both; state: State }) {
  const sun = state.panel;
  const curves: Curve[] = names.flatMap((name) => {
    const table = looked[name].angular.value;
    return table ? [{ name, table, dash: name === "a" ? "" : "6 4" }] : [];
  });
  // two panels may be known at different elevations while they are computed
  const table = () => (curves.length === 1 ? curves[0].table : curvesSideBySide(curves));
  const isRough = names.some((name) => looked[name].lobes.value?.is_smooth === false);
  return (
    <>
      <Figure name="deflection" title={said.curveTitle} hint={isRough ? said.curveRays : ""} table={curves.length ? table : undefined}>
        {names.map((name) => (
          <Progress key={name} job={looked[name].angular} />
        ))}
        <DrawAngular curves={curves} quantities={QUANTITIES} elevation={sun.elevation} words={words.share} label={said.curveTitle} axis={said.elevation} names={words.panelNames} />
      </Figure>
      <RadialFigure names={names} looked={looked} state={state} curves={curves} table={curves.length ? table : undefined} />
    </>
  );
}

function RadialFigure({ names, looked, state, curves, table }: { names: Names; looked: Both; state: State; curves: Curve[]; table?: () => Record<string, (number | string)[]> }) {
  const sun = state.panel;
  const rough = (name: "a" | "b") => looked[name].lobes.value?.is_smooth === false;
  const spread = (name: "a" | "b") => (rough(name) ? (looked[name].walk.value?.distribution ?? null) : null);
  const isFrom = sun.radial === "from";
  const goes = (): Record<string, (number | string)[]> => {
    const found = spread("a");
    if (!found) return beamTable(looked.a.lobes.value?.lobes ?? []);
    return { elevation_low_deg: found.edges_deg.slice(0, -1), elevation_high_deg: found.edges_deg.slice(1), front_share: found.front, back_share: found.back };
  };
  return (
    <Figure name={isFrom ? "radial" : "radial-leaves"} title={said.radialTitle} hint={isFrom ? said.radialHint.from : names.some(rough) ? said.radialHint.spread : said.radialHint.to} table={isFrom ? table : goes}>
      <div class="bar">
        <ChoiceInput id="radial" label="" name={said.radialTitle} value={sun.radial} options={Object.entries(said.radial)} onChange={(radial) => change("panel", { radial })} />
      </div>
      {isFrom ? (
        <DrawRadial curves={curves} quantities={RADIAL} elevation={sun.elevation} side={sun.side} words={{ transmittance: words.goesThrough, reflectance: words.comesBack }} label={said.radialTitle} names={words.panelNames} />
      ) : (
        <div class="pair">
          {names.map((name) => (
            <div key={name} data-goes={name}>
              {names.length > 1 && <p class="hint">{words.panelNames[name]}</p>}
              <DrawGoes
                lobes={looked[name].lobes.value?.lobes ?? []}
                spread={spread(name)}
                elevation={sun.elevation}
                side={sun.side}
                label={`${said.radial.to}${names.length > 1 ? `, ${words.panelNames[name]}` : ""}`}
                words={{ transmittance_deflected: words.deflected, transmittance_undeflected: "undeflected", reflectance: words.comesBack }}
                outside={words.outside}
                room={words.room}
              />
            </div>
          ))}
        </div>
      )}
    </Figure>
  );
}

/** A column of each panel, at the elevations of both. */
function curvesSideBySide(curves: Curve[]): Record<string, (number | string)[]> {
  const all = [...new Set(curves.flatMap((curve) => curve.table.elevation_deg))].sort((a, b) => a - b);
  const columns: Record<string, (number | string)[]> = { elevation_deg: all };
  for (const { name, table } of curves) {
    const at = new Map(table.elevation_deg.map((deg, k) => [deg, k]));
    for (const key of Object.keys(table)) if (key !== "elevation_deg") columns[`${name}_${key}`] = all.map((deg) => (at.has(deg) ? table[key][at.get(deg) as number] : ""));
  }
  return columns;
}

export function DispersionFigure({ name, names, looked, state, follows, onFollow }: { name: "a" | "b"; names: Names; looked: Looked; state: State; follows: boolean; onFollow: (follows: boolean) => void }) {
  const job = looked.dispersion;
  const [shown, setShown] = useState<"room" | "outside">("room");
  const data = job.isStale && !follows ? null : job.value;
  const title = titled(said.dispersionTitle, name, names);
  const isBack = shown === "room";
  const table = () => ({
    wavelength_nm: data?.beams.map((beam) => beam.wavelength_nm) ?? [],
    elevation_deg: data?.beams.map((beam) => beam.elevation_deg) ?? [],
    azimuth_deg: data?.beams.map((beam) => beam.azimuth_deg) ?? [],
    power: data?.beams.map((beam) => beam.power) ?? [],
    side: data?.beams.map((beam) => beam.side) ?? [],
  });
  return (
    <Figure name={`dispersion-${name}`} title={title} hint={said.dispersionHint} table={data ? table : undefined}>
      <div class="bar">
        <label class="check">
          <input type="checkbox" checked={follows} onChange={(event) => onFollow(event.currentTarget.checked)} /> {said.follow}
        </label>
        {data && <ChoiceInput id={`${name}-dispersion-side`} label="" name={said.dispersionTitle} value={shown} options={[["room", words.room], ["outside", words.outside]]} onChange={(to) => setShown(to as "room" | "outside")} />}
        {!follows && !data && job.state !== "waiting" && job.state !== "running" && <button onClick={job.start}>{words.again}</button>}
      </div>
      <Progress job={job} isQuiet={follows} />
      {data && (
        <div class={state.panel.elevation === undefined || (job.isStale && follows) ? "stale" : ""}>
          <DrawDispersion data={data} side={isBack ? "back" : "front"} axis={words.leavesAt} across={words.wavelength} label={title} nothing={said.noBeams} />
        </div>
      )}
    </Figure>
  );
}
