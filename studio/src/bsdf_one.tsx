// One BSDF at the incidence chosen: its discs, a cut, its files.

import { useState } from "preact/hooks";
import type { BsdfTold, Cut, Discs, Point } from "./answers";
import { askBlob, type Fault, Refused } from "./ask";
import type { Slot } from "./bsdf_open";
import type { BsdfState } from "./bsdf_state";
import { DrawCut } from "./draw_cut";
import { DrawDisc } from "./draw_disc";
import { sunOf } from "./draw_sky";
import { type Answer, useAnswer } from "./follow";
import { ChoiceInput, Faults } from "./inputs";
import { Figure, saveFile } from "./save";
import { change } from "./state";
import { words } from "./words";
import { bsdf as said } from "./words/bsdf";
import { panel as saidPanel } from "./words/panel";

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

/** Light that travels along a point of a disc comes from the opposite one. */
export function pickIncidence([x, y]: Point) {
  const [elevation, azimuth] = sunOf([-x, -y]);
  change("bsdf", { elevation: Math.round(elevation), azimuth: Math.round(azimuth) });
}

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
  const most = Math.max(...(discs.value?.outgoing.flatMap((one) => one.values) ?? []), 1e-9);
  const missing = ["transmission", "reflection"].map((word) => `${word}_${look.side}`).filter((name) => !(name in (told.bands[look.band] ?? {})));
  const discTable = () => {
    const rows = discs.value?.outgoing.flatMap((one) => one.values.map((value, cell) => ({ word: one.word, cell, value }))) ?? [];
    return { block: rows.map((row) => row.word), cell: rows.map((row) => row.cell + 1), bsdf_per_sr: rows.map((row) => row.value) };
  };
  const cutTable = () => Object.assign({ angle_deg: cut.value?.angle_deg ?? [] }, ...(cut.value?.curves.map((curve) => ({ [`${curve.word.toLowerCase()}_per_sr`]: curve.values })) ?? []));
  return (
    <>
      <Figure name={`bsdf-discs${suffix}`} title={title(said.discTitle)} hint={said.seen} table={discs.value ? discTable : undefined}>
        <FileBar slot={slot} told={told} look={look} />
        <Faults faults={discs.faults} />
        {missing.map((name) => (
          <p key={name} class="hint">
            {said.missing(said.blocks[name])}
          </p>
        ))}
        {discs.value && (
          <div class={`discs${discs.faults.length ? " stale" : ""}`}>
            <DrawDisc
              title={words.comesAlong(discs.value.incident.word)}
              label={`${words.comesAlong(discs.value.incident.word)}. ${said.pickHelp}`}
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
              onPick={pickIncidence}
              reads={said.valueAt}
            />
            {discs.value.outgoing.map((one) => (
              <DrawDisc
                key={one.word}
                title={`${words.leavesAlong(one.word)}, ${(100 * one.share).toFixed(1)} %`}
                label={`${words.leavesAlong(one.word)}, ${(100 * one.share).toFixed(1)} percent. ${said.readHelp}`}
                cells={one.cells}
                values={one.values}
                isLogarithmic={isLog}
                least={isLog ? most * 1e-4 : 0}
                most={most}
                unit={words.perSteradian}
                up={words.up}
                right={words.right}
                nothing={words.noLight}
                point={discs.value?.point}
                reads={said.valueAt}
              />
            ))}
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
  const [faults, setFaults] = useState<Fault[]>([]);
  const save = async (format: string) => {
    if (!format) return;
    try {
      const name = told.name.replace(/[^\w.-]+/g, "_") || "bsdf";
      saveFile(`${name}.${format}`, await askBlob("/api/bsdf/file", { key: told.key, format, band: look.band, direction: `transmission_${look.side}`, ...(basis ? { basis } : {}) }));
      setFaults([]);
    } catch (fault) {
      setFaults((fault as Refused).faults ?? []);
    }
  };
  return (
    <>
      <div class="bar">
        <ChoiceInput id={`${slot}-file-basis`} label={said.basis} value={basis} options={[["", said.asIs], ...Object.entries(saidPanel.bases)]} onChange={setBasis} />
        <select aria-label={`${said.files}, ${said.names[slot]}`} value="" onChange={(event) => void save(event.currentTarget.value)}>
          <option value="">{said.files} …</option>
          {Object.entries(said.formats).map(([format, label]) => (
            <option key={format} value={format}>
              {label}
            </option>
          ))}
        </select>
      </div>
      <Faults faults={faults} />
    </>
  );
}
