// One BSDF at the incidence chosen: its discs, a cut, its files.

import { useState } from "preact/hooks";
import { DrawCut } from "../draw/cut";
import { FormatChoice, useBsdfFile } from "../parts/bsdf_save";
import { DiscGroup, discTable } from "../parts/disc_group";
import { ChoiceInput, Faults } from "../parts/inputs";
import { Figure } from "../parts/save";
import type { BsdfTold, Cut, Discs } from "../server/answers";
import { type Answer, useAnswer } from "../server/follow";
import { change } from "../state/state";
import { bsdf as said } from "../words/bsdf";
import { words } from "../words/page";
import { panel as saidPanel } from "../words/panel";
import type { Slot } from "./open";
import type { BsdfState } from "./state";

export interface LookedAt {
  discs: Answer<Discs>;
  cut: Answer<Cut>;
}

export function useLookedAt(key: string, look: BsdfState): LookedAt {
  const incidence = { key, elevation_deg: look.elevation, azimuth_deg: look.azimuth, side: look.side, band: look.band };
  const discs = useAnswer<Discs>("/api/bsdf/discs", key ? incidence : null);
  const cut = useAnswer<Cut>("/api/bsdf/cut", key ? { ...incidence, plane_deg: look.plane } : null);
  return { discs, cut };
}

const setIncidence = (elevation: number, azimuth: number) => change("bsdf", { elevation: Math.round(elevation), azimuth: Math.round(azimuth) });

interface Props {
  slot: Slot;
  told: BsdfTold;
  look: BsdfState;
  looked: LookedAt;
}

export function BsdfFigures({ slot, told, look, looked }: Props) {
  const { discs, cut } = looked;
  const suffix = look.compares ? `-${slot}` : "";
  const title = (text: string) => (look.compares ? `${text}: ${said.names[slot]}` : text);
  const isLog = look.scale === "log";
  const missing = ["transmission", "reflection"].map((word) => `${word}_${look.side}`).filter((name) => !(name in (told.bands[look.band] ?? {})));
  const cutTable = () => Object.assign({ angle_deg: cut.value?.angle_deg ?? [] }, ...(cut.value?.curves.map((curve) => ({ [`${curve.word.toLowerCase()}_per_sr`]: curve.values })) ?? []));
  return (
    <>
      <Figure name={`bsdf-discs${suffix}`} title={title(said.discTitle)} hint={said.seen} table={discs.value ? () => discTable(discs.value as Discs, "cell") : undefined}>
        <FileBar slot={slot} told={told} look={look} />
        <Faults faults={discs.faults} />
        {missing.map((name) => (
          <p key={name} class="hint">
            {said.missing(said.blocks[name])}
          </p>
        ))}
        {discs.value && (
          <div class={`discs${discs.faults.length ? " stale" : ""}`}>
            <DiscGroup discs={discs.value} isLogarithmic={isLog} onSun={setIncidence} />
          </div>
        )}
      </Figure>
      {cut.value && (
        <Figure name={`bsdf-cut${suffix}`} title={title(words.cutTitle)} table={cutTable}>
          <DrawCut cut={cut.value} isFront={look.side === "front"} isLogarithmic={isLog} outside={words.outside} room={words.room} unit={words.perSteradian} label={`${words.cutTitle}: ${cut.value.curves.map((curve) => `${curve.word} ${Math.max(...curve.values).toPrecision(2)} ${words.perSteradian}`).join(", ")}`} />
        </Figure>
      )}
    </>
  );
}

/** The file as other programs read it. */
function FileBar({ slot, told, look }: { slot: Slot; told: BsdfTold; look: BsdfState }) {
  const [basis, setBasis] = useState("");
  const name = told.name.replace(/[^\w.-]+/g, "_") || "bsdf";
  const { save, faults } = useBsdfFile(name, { key: told.key, band: look.band, direction: `transmission_${look.side}`, ...(basis ? { basis } : {}) });
  return (
    <>
      <div class="bar">
        <ChoiceInput id={`${slot}-file-basis`} label={said.basis} value={basis} options={[["", said.asIs], ...Object.entries(saidPanel.bases)]} onChange={setBasis} />
        <FormatChoice label={`${said.files}, ${said.names[slot]}`} onSave={save} />
      </div>
      <Faults faults={faults} />
    </>
  );
}
