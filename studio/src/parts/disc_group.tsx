// The discs of a BSDF at one incidence: where the light comes from, and where it leaves.

import { useMemo } from "preact/hooks";
import { DrawDisc } from "../draw/disc";
import { sunOf } from "../draw/sky";
import type { Discs, Point } from "../server/answers";
import { bsdf as said } from "../words/bsdf";
import { words } from "../words/page";

/** Decades below the brightest cell that a logarithmic scale shows. */
const DECADES = 4;

interface Props {
  discs: Discs;
  isLogarithmic: boolean;
  /** A place of the first disc was chosen. */
  onSun: (elevation: number, azimuth: number) => void;
}

export function DiscGroup({ discs, isLogarithmic, onSun }: Props) {
  // hundreds of patches, and a drag draws the view several times for each of its answers
  return useMemo(() => <Group discs={discs} isLogarithmic={isLogarithmic} onSun={onSun} />, [discs, isLogarithmic, onSun]);
}

function Group({ discs, isLogarithmic, onSun }: Props) {
  const { incident, outgoing, point, picked } = discs;
  const most = Math.max(...outgoing.flatMap((one) => one.values), 1e-9);
  // light that travels along a point of a disc comes from the opposite one
  const pick = ([x, y]: Point) => onSun(...sunOf([-x, -y]));
  const shared = { up: words.up, right: words.right, nothing: words.noLight, point, reads: said.valueAt };
  return (
    <>
      <DrawDisc
        title={words.comesAlong(incident.word)}
        label={`${words.comesAlong(incident.word)}. ${said.pickHelp}`}
        cells={incident.cells}
        values={incident.values}
        isLogarithmic={false}
        least={0}
        most={Math.max(...incident.values, 1e-9)}
        unit={words.shareOfPower}
        picked={picked}
        onPick={pick}
        {...shared}
      />
      {outgoing.map((one) => {
        const share = (100 * one.share).toFixed(1);
        const error = one.standard_error !== null && one.standard_error >= 5e-5 ? ` ± ${(100 * one.standard_error).toFixed(1)}` : "";
        return (
          <DrawDisc
            key={one.word}
            title={`${words.leavesAlong(one.word)}, ${share} %${error}`}
            label={`${words.leavesAlong(one.word)}, ${share} percent. ${said.readHelp}`}
            cells={one.cells}
            values={one.values}
            isLogarithmic={isLogarithmic}
            least={isLogarithmic ? most * 10 ** -DECADES : 0}
            most={most}
            unit={words.perSteradian}
            {...shared}
          />
        );
      })}
    </>
  );
}

/** The values of the discs as columns, their cells counted from 1. */
export function discTable({ outgoing }: Discs, cell: "cell" | "patch"): Record<string, (number | string)[]> {
  const rows = outgoing.flatMap((one) => one.values.map((value, k) => ({ word: one.word, number: k + 1, value })));
  return { block: rows.map((row) => row.word), [cell]: rows.map((row) => row.number), bsdf_per_sr: rows.map((row) => row.value) };
}
