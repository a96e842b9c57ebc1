// One panel: its section with the light, its numbers, its beams.

import { DrawSection } from "../draw/section";
import { DrawShares } from "../draw/shares";
import { Heads } from "../parts/data_table";
import { Figure } from "../parts/save";
import type { Lobe, Shares } from "../server/answers";
import type { State } from "../state/state";
import { words } from "../words/page";
import { panel as said } from "../words/panel";
import type { Looked } from "./follow";

/** Beams in the table; the file has more. */
const MOST_ROWS = 12;

interface Props {
  name: "a" | "b";
  looked: Looked;
  state: State;
  isDark: boolean;
  onSun: (elevation: number) => void;
}

/** Shares and their standard errors: those of the refining rays, if there are any. */
export function sharesOf(looked: Looked): { shares: Shares | null; errors: Shares | null; rays: number | null } {
  const { lobes, walk } = looked;
  const isWalked = lobes.value?.is_smooth === false && walk.value && !walk.isStale;
  const from = isWalked ? walk.value : lobes.value;
  return { shares: from?.shares ?? null, errors: from?.standard_errors ?? null, rays: from?.rays ?? null };
}

export function beamTable(lobes: Lobe[]): Record<string, (number | string)[]> {
  return {
    power: lobes.map((lobe) => lobe.power),
    side: lobes.map((lobe) => lobe.side),
    elevation_deg: lobes.map((lobe) => lobe.elevation_deg),
    azimuth_deg: lobes.map((lobe) => lobe.azimuth_deg),
    total_reflections: lobes.map((lobe) => lobe.total_reflections),
  };
}

/** Shares as rows, with their standard errors if they have some. */
function shareTable(shares: Shares | null, errors: Shares | null): Record<string, (number | string)[]> {
  const names = Object.keys(shares ?? {});
  return { share: names, value: names.map((name) => shares?.[name] ?? ""), ...(errors ? { standard_error: names.map((name) => errors[name]) } : {}) };
}

export function OnePanel({ name, looked, state, isDark, onSun }: Props) {
  const { section, lobes } = looked;
  const { shares, errors, rays } = sharesOf(looked);
  const sun = state.panel;
  const isRough = lobes.value?.is_smooth === false;
  const title = sun.compares ? words.panelNames[name] : said.section;
  const beams = lobes.value?.lobes.filter((lobe) => lobe.power >= 5e-4) ?? [];
  const hints = [section.value && !section.value.is_smooth ? said.roughSection : "", Math.abs(sun.azimuth) > 0.05 ? said.projected : ""].filter(Boolean);
  const worst = errors ? Math.max(...Object.values(errors)) : 0;
  return (
    <div class="onePanel" data-panel={name} data-coarse={lobes.isCoarse}>
      <Figure name={`section-${name}`} title={title} hint={hints.join(" ")} table={beams.length ? () => beamTable(lobes.value?.lobes ?? []) : () => shareTable(shares, errors)}>
        <DrawSection
          section={section.value}
          elevation={sun.elevation}
          azimuth={sun.azimuth}
          side={sun.side}
          isDark={isDark}
          isStale={section.faults.length > 0}
          label={words.sectionText(sun.elevation, shares?.transmittance ?? 0, shares?.transmittance_deflected ?? 0)}
          sunLabel={words.dragSun}
          outside={words.outside}
          room={words.room}
          onSun={onSun}
        />
      </Figure>
      <div class="numbers" aria-live="off">
        {Object.entries(said.symbols).map(([key, symbol]) => (
          <div key={key} title={said.names[key]}>
            <b data-number={key} data-value={shares?.[key] ?? ""} data-error={errors?.[key] ?? ""}>
              {shares ? `${(100 * shares[key]).toFixed(1)} %` : "…"}
            </b>
            <span>{symbol}</span>
          </div>
        ))}
      </div>
      <DrawShares shares={shares} errors={isRough ? errors : null} words={words.share} label={words.shares} isStale={lobes.faults.length > 0} />
      <p class="hint told" role="status">
        {rays ? `${said.byRays(rays, worst)}. ` : ""}
        {lobes.isCoarse && rays ? said.coarse : ""}
        {isRough && looked.walk.state === "running" ? `${said.refining} …` : ""}
      </p>
      <details open={!sun.compares}>
        <summary>{words.beams}</summary>
        {isRough && <p class="hint">{said.beamsNone}</p>}
        {beams.length > 0 && (
          <table>
            <Heads words={words.beamHeads} />
            <tbody>
              {beams.slice(0, MOST_ROWS).map((beam, k) => (
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
        )}
        {(lobes.value?.count ?? 0) > MOST_ROWS && <p class="hint">{said.beamsMore(Math.min(MOST_ROWS, beams.length), lobes.value?.count ?? 0)}</p>}
      </details>
    </div>
  );
}
