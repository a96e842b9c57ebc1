// Shares of BSDFs: at one incidence, against elevation, and of light from everywhere.

import { type Curve, DrawCurve } from "../draw/curve";
import { Heads } from "../parts/data_table";
import { Faults } from "../parts/inputs";
import { Figure } from "../parts/save";
import type { Discs, ShareCurve } from "../server/answers";
import { type Answer, useAnswer } from "../server/follow";
import { bsdf as said } from "../words/bsdf";
import { words } from "../words/page";
import { panel as saidPanel } from "../words/panel";
import type { BsdfState } from "./state";

const BLOCKS = ["Transmitted", "Reflected"];

interface Props {
  keys: string[];
  discs: Answer<Discs>[];
  look: BsdfState;
}

/** The numbers of one BSDF, or of two with their difference. */
export function BsdfNumbers({ keys, discs, look }: Props) {
  const names = keys.length > 1 ? [said.names.a, said.names.b] : [""];
  const found = (at: number, word: string) => discs[at]?.value?.outgoing.find((one) => one.word === word);
  const percent = (value: number | undefined) => (value === undefined ? "–" : `${(100 * value).toFixed(2)} %`);
  const rows = BLOCKS.filter((word) => keys.some((_, at) => found(at, word)));
  const first = useCurve(keys[0] ?? "", look);
  const second = useCurve(keys[1] ?? "", look);
  const curves: Curve[] = [first, second].flatMap(({ value }, at) => (value && keys[at] ? value.curves.map((one) => ({ word: one.word, name: names[at], isSecond: at === 1, elevation_deg: value.elevation_deg, values: one.values })) : []));
  const curveTable = () => Object.assign({ elevation_deg: curves[0]?.elevation_deg ?? [] }, ...curves.map((one) => ({ [`${one.isSecond ? "b_" : keys.length > 1 ? "a_" : ""}${one.word.toLowerCase()}`]: one.values })));
  const numberTable = () => ({ block: rows, ...Object.assign({}, ...keys.map((_, at) => ({ [`${"ab"[at]}_at_incidence`]: rows.map((word) => found(at, word)?.share ?? ""), [`${"ab"[at]}_from_everywhere`]: rows.map((word) => found(at, word)?.mean ?? "") }))) });
  return (
    <div class="grid">
      <Figure name="bsdf-numbers" title={`${said.numbers}: ${saidPanel.skyText(look.elevation, look.azimuth)}`} table={numberTable} noPicture>
        <table class="differences">
          <Heads words={names.length > 1 ? ["", ...names, saidPanel.differenceHeads[3]] : [words.shares, ...said.numberHeads.slice(1, 3)]} />
          <tbody>
            {rows.map((word) => {
              const [a, b] = [found(0, word)?.share, found(1, word)?.share];
              return (
                <tr key={word}>
                  <th scope="row">{word}</th>
                  <td data-bsdf={`a-${word}`} data-value={a}>
                    {percent(a)}
                  </td>
                  {names.length > 1 ? (
                    <>
                      <td data-bsdf={`b-${word}`} data-value={b}>
                        {percent(b)}
                      </td>
                      <td>{a === undefined || b === undefined ? "–" : `${b < a ? "−" : "+"}${(100 * Math.abs(b - a)).toFixed(2)}`}</td>
                    </>
                  ) : (
                    <td>{percent(found(0, word)?.mean)}</td>
                  )}
                </tr>
              );
            })}
            {names.length > 1 &&
              rows.map((word) => {
                const [a, b] = [found(0, word)?.mean, found(1, word)?.mean];
                return (
                  <tr key={`${word} mean`}>
                    <th scope="row">
                      {word}, {said.numberHeads[2].toLowerCase()}
                    </th>
                    <td>{percent(a)}</td>
                    <td>{percent(b)}</td>
                    <td>{a === undefined || b === undefined ? "–" : `${b < a ? "−" : "+"}${(100 * Math.abs(b - a)).toFixed(2)}`}</td>
                  </tr>
                );
              })}
          </tbody>
        </table>
      </Figure>
      <Figure name="bsdf-shares" title={said.curveTitle} hint={said.curveHint} table={curves.length ? curveTable : undefined}>
        <Faults faults={[...first.faults, ...second.faults]} />
        <DrawCurve curves={curves} elevation={look.elevation} axis={saidPanel.elevation} label={said.curveTitle} />
      </Figure>
    </div>
  );
}

function useCurve(key: string, look: BsdfState): Answer<ShareCurve> {
  return useAnswer<ShareCurve>("/api/bsdf/curve", key ? { key, azimuth_deg: look.azimuth, side: look.side, band: look.band } : null);
}
