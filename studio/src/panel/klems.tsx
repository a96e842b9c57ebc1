// The BSDF of a panel over Klems patches: coarse at once, with the time left, and as files of other programs.

import { FormatChoice, useBsdfFile } from "../parts/bsdf_save";
import { DiscGroup, discTable } from "../parts/disc_group";
import { ChoiceInput, Faults } from "../parts/inputs";
import { Figure } from "../parts/save";
import type { Discs } from "../server/answers";
import { change, type State } from "../state/state";
import { words } from "../words/page";
import { panel as said } from "../words/panel";
import type { Looked } from "./follow";
import { setSun } from "./sun";

interface Props {
  name: string;
  title: string;
  looked: Looked;
  state: State;
}

export function KlemsFigure({ name, title, looked, state }: Props) {
  const { klems, discs } = looked;
  const sun = state.panel;
  const key = klems.isStale ? "" : (klems.value?.key ?? "");
  const { save, faults } = useBsdfFile(`panel-${name}`, { key, band: sun.band });
  const isBusy = !klems.isStale && (klems.state === "waiting" || klems.state === "running");
  const table = () => discTable(discs.value as Discs, "patch");
  const isWhole = key !== "" && klems.state === "done";
  return (
    <Figure name={`klems-${name}`} title={title} hint={said.klemsHint} table={discs.value && key ? table : undefined} extra={isWhole ? [{ label: "XML", save: () => save("xml") }] : []}>
      <div class="bar">
        <ChoiceInput id={`${name}-basis`} label={said.basis} value={sun.basis} options={Object.entries(said.bases)} onChange={(basis) => change("panel", { basis })} />
        <ChoiceInput id={`${name}-accuracy`} label={said.accuracy} value={sun.accuracy} options={Object.entries(said.accuracies)} onChange={(accuracy) => change("panel", { accuracy })} />
        <ChoiceInput id={`${name}-band`} label={said.band} value={sun.band} options={Object.entries(said.bands)} onChange={(band) => change("panel", { band })} />
        {!isBusy && !isWhole && <button onClick={klems.start}>{words.again}</button>}
        {isWhole && <FormatChoice label={said.save} onSave={save} />}
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
          <DiscGroup discs={discs.value} isLogarithmic onSun={setSun} />
        </div>
      )}
    </Figure>
  );
}
