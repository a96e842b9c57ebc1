// What a panel is made of: a medium by its name, or one of an index and an absorption of its own.

import { ChoiceInput, SliderInput } from "../parts/inputs";
import type { Fault } from "../server/ask";
import type { Value } from "../state/state";
import { panel as said } from "../words/panel";

type Own = { n: number; absorption_per_mm?: number };

interface Props {
  id: string;
  label: string;
  value: Value | undefined;
  start: string;
  media: string[];
  faults: Fault[];
  onChange: (value: Value) => void;
}

export function MediumInput({ id, label, value, start, media, faults, onChange }: Props) {
  const table = value !== null && typeof value === "object" && !Array.isArray(value) ? value : null;
  const own = table && typeof table.n === "number" && Object.keys(table).every((name) => name === "n" || name === "absorption_per_mm") ? (table as Own) : null;
  const word = typeof value === "string" ? value : own ? "own" : table ? "file" : start;
  const options = media.map((name): [string, string] => [name, said.media[name] ?? name]);
  options.push(["own", said.ownMedium]);
  if (word === "file") options.push(["file", said.fileMedium]);
  const turn = (to: string) => {
    if (to === "own") onChange({ n: 1.49, absorption_per_mm: 0 });
    else if (to !== "file") onChange(to);
  };
  const slide = (changed: Partial<Own>) => onChange({ n: own?.n ?? 1.49, absorption_per_mm: own?.absorption_per_mm ?? 0, ...changed });
  return (
    <>
      <ChoiceInput id={id} label={label} value={word} options={options} onChange={turn} />
      {own && (
        <>
          <SliderInput id={`${id}-n`} field="n" label={said.index} value={own.n} low={Math.min(1.3, own.n)} high={Math.max(2, own.n)} step={0.005} unit="" faults={faults} onChange={(n) => slide({ n })} />
          <SliderInput id={`${id}-absorption`} field="absorption_per_mm" label={said.absorption} value={own.absorption_per_mm ?? 0} low={0} high={Math.max(0.05, own.absorption_per_mm ?? 0)} step={0.0005} unit="/mm" faults={faults} onChange={(absorption_per_mm) => slide({ absorption_per_mm })} />
        </>
      )}
    </>
  );
}
