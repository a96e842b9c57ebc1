// The BSDF of a panel over Klems patches: coarse at once, with the time left, and as files of other programs.

import type { Point } from "./answers";
import { askBlob, type Fault, Refused } from "./ask";
import { DrawDisc } from "./draw_disc";
import { sunOf } from "./draw_sky";
import { ChoiceInput, Faults } from "./inputs";
import type { Looked } from "./panel_follow";
import { setSun } from "./panel_sun";
import { Figure, saveFile } from "./save";
import { change, type State } from "./state";
import { useState } from "preact/hooks";
import { words } from "./words";
import { bsdf as saidBsdf } from "./words/bsdf";
import { panel as said } from "./words/panel";

interface Props {
  name: string;
  title: string;
  looked: Looked;
  state: State;
}

export function KlemsFigure({ name, title, looked, state }: Props) {
  const { klems, discs } = looked;
  const sun = state.panel;
  const [faults, setFaults] = useState<Fault[]>([]);
  const key = klems.isStale ? "" : (klems.value?.key ?? "");
  const isBusy = !klems.isStale && (klems.state === "waiting" || klems.state === "running");
  const most = Math.max(...(discs.value?.outgoing.flatMap((one) => one.values) ?? []), 1e-9);
  const pick = ([x, y]: Point) => setSun(...sunOf([-x, -y]));
  const file = async (format: string) => {
    if (!format) return;
    try {
      saveFile(`panel-${name}.${format}`, await askBlob("/api/bsdf/file", { key, format, band: sun.band }));
      setFaults([]);
    } catch (fault) {
      setFaults((fault as Refused).faults ?? []);
    }
  };
  const table = () => {
    const rows = discs.value?.outgoing.flatMap((one) => one.values.map((value, patch) => ({ word: one.word, patch, value }))) ?? [];
    return { block: rows.map((row) => row.word), patch: rows.map((row) => row.patch + 1), bsdf_per_sr: rows.map((row) => row.value) };
  };
  const isWhole = key !== "" && klems.state === "done";
  return (
    <Figure name={`klems-${name}`} title={title} hint={said.klemsHint} table={discs.value && key ? table : undefined} extra={isWhole ? [{ label: "XML", save: () => void file("xml") }] : []}>
      <div class="bar">
        <ChoiceInput id={`${name}-basis`} label={said.basis} value={sun.basis} options={Object.entries(said.bases)} onChange={(basis) => change("panel", { basis })} />
        <ChoiceInput id={`${name}-accuracy`} label={said.accuracy} value={sun.accuracy} options={Object.entries(said.accuracies)} onChange={(accuracy) => change("panel", { accuracy })} />
        <ChoiceInput id={`${name}-band`} label={said.band} value={sun.band} options={Object.entries(said.bands)} onChange={(band) => change("panel", { band })} />
        {!isBusy && !isWhole && <button onClick={klems.start}>{words.again}</button>}
        {isWhole && (
          <select aria-label={said.save} value="" onChange={(event) => void file(event.currentTarget.value)}>
            <option value="">{saidBsdf.files} …</option>
            {Object.entries(saidBsdf.formats).map(([format, label]) => (
              <option key={format} value={format}>
                {label}
              </option>
            ))}
          </select>
        )}
      </div>
      {isBusy && (
        <p class="progress">
          <progress value={klems.share || undefined} max={1} aria-label={words.working} />
          <span role="status">
            {Math.round(100 * klems.share)} %{klems.value?.left_s !== undefined ? `, ${said.left(klems.value.left_s)}` : ""}
          </span>
          <button onClick={klems.stop}>{words.stop}</button>
        </p>
      )}
      {klems.state === "cancelled" && !klems.isStale && <p class="hint">{words.stopped}</p>}
      <Faults faults={[...klems.faults, ...faults, ...discs.faults]} />
      {key && !isWhole && <p class="hint">{said.preview}</p>}
      {key && discs.value && (
        <div class="discs" data-key={key} data-whole={isWhole}>
          <DrawDisc
            title={words.comesAlong(discs.value.incident.word)}
            label={`${words.comesAlong(discs.value.incident.word)}. ${saidBsdf.pickHelp}`}
            cells={discs.value.incident.cells}
            values={discs.value.incident.values}
            isLogarithmic={false}
            least={0}
            most={Math.max(...discs.value.incident.values, 1e-9)}
            unit={words.shareOfPower}
            up={words.up}
            right={words.right}
            nothing={words.noLight}
            point={discs.value.point}
            picked={discs.value.picked}
            onPick={pick}
            reads={saidBsdf.valueAt}
          />
          {discs.value.outgoing.map((one) => (
            <DrawDisc
              key={one.word}
              title={`${words.leavesAlong(one.word)}, ${(100 * one.share).toFixed(1)} %${one.standard_error !== null && one.standard_error >= 5e-5 ? ` ± ${(100 * one.standard_error).toFixed(1)}` : ""}`}
              label={`${words.leavesAlong(one.word)}. ${saidBsdf.readHelp}`}
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
              reads={saidBsdf.valueAt}
            />
          ))}
        </div>
      )}
    </Figure>
  );
}
