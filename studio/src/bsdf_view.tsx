// Anybody's BSDF: dropped or opened, looked at, checked in plain words.

import { useEffect, useState } from "preact/hooks";
import type { About, BsdfTold, Cut, Discs, Point } from "./answers";
import { ask, askText, type Fault, Refused, send } from "./ask";
import { DrawCut } from "./draw_cut";
import { DrawDisc } from "./draw_disc";
import { useAnswer, useOnce } from "./follow";
import { ChoiceInput, chosen, Faults, SliderInput } from "./inputs";
import { Figure, saveFile } from "./save";
import { change, type State } from "./state";
import { words } from "./words";

export function BsdfView({ state }: { state: State }) {
  const look = state.bsdf;
  const about = useOnce<About>("/api/about");
  const [told, setTold] = useState<BsdfTold | null>(null);
  const [faults, setFaults] = useState<Fault[]>([]);
  const [isOver, setIsOver] = useState(false);
  const took = (found: BsdfTold, path: string) => {
    setTold(found);
    setFaults([]);
    const bands = Object.keys(found.bands);
    change("bsdf", { key: found.key, path, band: bands.includes(look.band) ? look.band : bands[0] });
  };
  const refuse = (fault: unknown) => setFaults((fault as Refused).faults ?? [{ field: null, message: String(fault) }]);
  useEffect(() => {
    if (told && told.key === look.key) return;
    if (!look.key && !look.path) return;
    ask<BsdfTold>("/api/bsdf/open", look.path ? { path: look.path } : { key: look.key }).then(
      (found) => took(found, look.path),
      (fault) => (look.path ? refuse(fault) : setFaults([{ field: null, message: words.gone }])),
    );
  }, [look.key, look.path]);
  const drop = async (file: File | undefined) => {
    if (!file) return;
    try {
      took(await send<BsdfTold>(`/api/bsdf?name=${encodeURIComponent(file.name)}`, file), "");
    } catch (fault) {
      setTold(null);
      change("bsdf", { key: "", path: "" });
      refuse(fault);
    }
  };
  const files = about.value?.files.filter((file) => file.kind === "bsdf") ?? [];
  const key = told?.key === look.key ? told?.key : undefined;
  const incidence = { elevation_deg: look.elevation, azimuth_deg: look.azimuth, side: look.side, band: look.band };
  const discs = useAnswer<Discs>("/api/bsdf/discs", key ? { key, ...incidence } : null);
  const cut = useAnswer<Cut>("/api/bsdf/cut", key ? { key, ...incidence, plane_deg: look.plane } : null);
  const pick = async ([x, y]: Point) => {
    const at = await ask<{ elevation_deg: number; azimuth_deg: number }>("/api/bsdf/incidence", { x, y });
    change("bsdf", { elevation: Math.round(10 * at.elevation_deg) / 10, azimuth: Math.round(10 * at.azimuth_deg) / 10 });
  };
  const most = Math.max(...(discs.value?.outgoing.flatMap((one) => one.values) ?? []), 1e-9);
  const xml = async () => key && saveFile(`${told?.name ?? "bsdf"}.xml`, await askText("/api/bsdf/xml", { key }), "application/xml");
  const discTable = () => {
    const rows = discs.value?.outgoing.flatMap((one) => one.values.map((value, patch) => ({ word: one.word, patch, value }))) ?? [];
    return { block: rows.map((row) => row.word), cell: rows.map((row) => row.patch + 1), bsdf_per_sr: rows.map((row) => row.value) };
  };
  const cutTable = () => Object.assign({ angle_deg: cut.value?.angle_deg ?? [] }, ...(cut.value?.curves.map((curve) => ({ [`${curve.word.toLowerCase()}_per_sr`]: curve.values })) ?? []));
  return (
    <div
      class="view bsdfView"
      onDragOver={(event) => {
        event.preventDefault();
        setIsOver(true);
      }}
      onDragLeave={() => setIsOver(false)}
      onDrop={(event) => {
        event.preventDefault();
        setIsOver(false);
        void drop(event.dataTransfer?.files[0]);
      }}
    >
      <aside class="side" aria-label={words.views.bsdf}>
        <label class={`dropPlace${isOver ? " over" : ""}`}>
          {words.drop}
          <input type="file" accept=".xml,.nc" onChange={(event) => void drop(chosen(event))} />
        </label>
        {files.length > 0 && <ChoiceInput id="file" label={words.files} value={look.path} options={[["", words.chooseFile], ...files.map((file): [string, string] => [file.path, file.path])]} onChange={(path) => path && change("bsdf", { path, key: "" })} />}
        <Faults faults={faults} />
        {told && key && (
          <fieldset class="controls">
            <legend>{words.sun}</legend>
            <SliderInput id="elevation" field="elevation_deg" label={words.elevation} value={look.elevation} low={-89} high={89} step={1} unit="°" faults={discs.faults} onChange={(elevation) => change("bsdf", { elevation })} />
            <SliderInput id="azimuth" field="azimuth_deg" label={words.azimuth} value={look.azimuth} low={-89} high={89} step={1} unit="°" faults={discs.faults} onChange={(azimuth) => change("bsdf", { azimuth })} />
            <ChoiceInput id="side" label={words.side} value={look.side} options={Object.entries(words.sides)} onChange={(side) => change("bsdf", { side })} />
            <ChoiceInput id="band" label={words.band} value={look.band} options={Object.keys(told.bands).map((band) => [band, band])} onChange={(band) => change("bsdf", { band })} />
            <SliderInput id="plane" field="plane_deg" label={words.plane} value={look.plane} low={-90} high={90} step={5} unit="°" faults={cut.faults} onChange={(plane) => change("bsdf", { plane })} />
          </fieldset>
        )}
        <Faults faults={discs.faults} fields={["elevation_deg", "azimuth_deg"]} />
      </aside>
      <div class="main">
        {!told && <p class="hint big">{words.nothingOpen}</p>}
        {told && key && (
          <>
            <section class="figure about">
              <h2>{told.name}</h2>
              <p>
                {told.manufacturer}, {words.thickness} {told.thickness_mm === null ? words.unknown : `${told.thickness_mm} mm`}
              </p>
              <h3>{words.findings}</h3>
              <ul class="findings">
                {told.findings.map((finding, k) => (
                  <li key={k} class={finding.severity}>
                    <b>{words.severity[finding.severity]}</b> {finding.where}: {finding.text}
                  </li>
                ))}
                {!told.findings.some((finding) => finding.severity !== "note") && <li class="sound">{words.noFindings}</li>}
              </ul>
              {told.assumed.length > 0 && (
                <>
                  <h3>{words.assumed}</h3>
                  <ul>
                    {told.assumed.map((text) => (
                      <li key={text}>{text}</li>
                    ))}
                  </ul>
                </>
              )}
              <h3>{words.blocks}</h3>
              <table>
                <thead>
                  <tr>
                    {words.blockHeads.map((head) => (
                      <th key={head} scope="col">
                        {head}
                      </th>
                    ))}
                  </tr>
                </thead>
                <tbody>
                  {Object.entries(told.bands).flatMap(([band, blocks]) =>
                    Object.entries(blocks).map(([name, block]) => (
                      <tr key={band + name}>
                        <td>
                          {words.directions[name]}, {band}
                        </td>
                        <td>{block.normal.toFixed(4)}</td>
                        <td>{block.mean.toFixed(4)}</td>
                        <td>{block.most.toFixed(4)}</td>
                      </tr>
                    )),
                  )}
                </tbody>
              </table>
            </section>
            {discs.value && (
              <Figure name="discs" title={words.views.bsdf} hint={words.discHelp} table={discTable} extra={[{ label: "XML", save: () => void xml() }]}>
                <div class="discs">
                  <DrawDisc
                    title={words.comesAlong(discs.value.incident.word)}
                    label={`${words.comesAlong(discs.value.incident.word)}. ${words.discHelp}`}
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
                    onPick={(point) => void pick(point)}
                  />
                  {discs.value.outgoing.map((one) => (
                    <DrawDisc
                      key={one.word}
                      title={`${words.leavesAlong(one.word)}, ${(100 * one.share).toFixed(1)} %`}
                      label={words.leavesAlong(one.word)}
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
              </Figure>
            )}
            {cut.value && (
              <Figure name="cut" title={words.cutTitle} table={cutTable}>
                <DrawCut cut={cut.value} isFront={look.side === "front"} outside={words.outside} room={words.room} unit={words.perSteradian} label={words.cutTitle} />
              </Figure>
            )}
          </>
        )}
      </div>
    </div>
  );
}
