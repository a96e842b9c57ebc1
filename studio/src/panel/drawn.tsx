// A drawn panel: its outlines, path data, file, or the facets that a TOML file holds.

import { useEffect, useState } from "preact/hooks";
import { ChoiceInput } from "../parts/inputs";
import type { Kinds } from "../server/answers";
import type { Fault } from "../server/ask";
import type { Panel, Value } from "../state/state";
import { panel as said } from "../words/panel";
import { TextInput } from "./fields";
import { MediumInput } from "./medium";

interface Props {
  name: string;
  panel: Panel;
  kinds: Kinds;
  drawings: string[];
  faults: Fault[];
  onChange: (panel: Panel) => void;
}

/** What the source of a drawn panel needs. */
export function DrawnInputs({ name, panel, kinds, drawings, faults, onChange }: Props) {
  const kind = kinds.kinds.find((one) => one.kind === "drawn");
  const source = String(panel.source ?? "points");
  const text = kind?.texts.find((one) => one.source === source);
  const media = (Array.isArray(panel.media) ? panel.media : ["pmma"]) as Value[];
  return (
    <>
      {text && (
        <TextInput
          id={`${name}-${text.name}`}
          field={text.name}
          label={said.fields[text.name]}
          value={String(panel[text.name] ?? text.start)}
          rows={4}
          help={said.help[text.name]}
          faults={faults}
          onChange={(to) => onChange({ ...panel, [text.name]: to })}
        />
      )}
      {source === "file" && drawings.length === 0 && <p class="hint">{said.noFiles}</p>}
      {source === "file" && drawings.length > 0 && (
        <ChoiceInput
          id={`${name}-file`}
          label={said.fields.file}
          value={String(panel.file ?? "")}
          options={[["", said.chooseFile], ...drawings.map((path): [string, string] => [path, path])]}
          help={said.help.file}
          onChange={(file) => onChange({ ...panel, file })}
        />
      )}
      <MediaInputs name={name} media={media} kinds={kinds} faults={faults} onChange={(to) => onChange({ ...panel, media: to })} />
    </>
  );
}

function MediaInputs({ name, media, kinds, faults, onChange }: { name: string; media: Value[]; kinds: Kinds; faults: Fault[]; onChange: (media: Value[]) => void }) {
  return (
    <>
      {media.map((medium, k) => (
        <MediumInput
          key={k}
          id={`${name}-medium-${k + 1}`}
          label={media.length > 1 ? `${said.fields.medium} ${k + 1}` : said.fields.medium}
          value={medium}
          start="pmma"
          media={kinds.media}
          faults={faults}
          onChange={(to) => onChange(media.map((one, at) => (at === k ? to : one)))}
        />
      ))}
      <p class="hint">
        <button class="link" onClick={() => onChange([...media, "soda_lime_clear"])}>
          {said.addMedium}
        </button>{" "}
        {media.length > 1 && (
          <button class="link" onClick={() => onChange(media.slice(0, -1))}>
            {said.lessMedium}
          </button>
        )}
      </p>
    </>
  );
}

type Facet = { start: number[]; end: number[]; left: number; right: number; bulge?: number; film?: number };

/** The facets of a file's profile, a line each. */
export function FacetInputs({ name, panel, kinds, faults, onChange }: Omit<Props, "drawings">) {
  const profile = panel.profile as unknown as { pitch_mm: number; facets: Facet[] };
  const shown = profile.facets.map(line).join("\n");
  const [text, setText] = useState(shown);
  const [wrong, setWrong] = useState<Fault[]>([]);
  useEffect(() => {
    if (facetsOf(text).facets?.map(line).join("\n") !== shown) setText(shown);
  }, [shown]);
  const take = (typed: string) => {
    setText(typed);
    const { facets, line: at } = facetsOf(typed);
    setWrong(facets ? [] : [{ field: "facets", message: `${said.fields.facets}, ${at}: ${said.help.facets}` }]);
    if (facets) onChange({ ...panel, profile: { ...profile, facets } as unknown as Value });
  };
  const media = (Array.isArray(panel.media) ? panel.media : ["pmma"]) as Value[];
  return (
    <>
      <div class="input">
        <label for={`${name}-pitch`}>{said.fields.pitch_mm}</label>
        <span class="number">
          <input id={`${name}-pitch`} type="number" step={0.1} value={profile.pitch_mm} onInput={(event) => Number.isFinite(event.currentTarget.valueAsNumber) && onChange({ ...panel, profile: { ...profile, pitch_mm: event.currentTarget.valueAsNumber } as unknown as Value })} />
          <span class="unit">mm</span>
        </span>
      </div>
      <TextInput id={`${name}-facets`} field="facets" label={said.fields.facets} value={text} rows={8} help={said.help.facets} faults={[...wrong, ...faults.filter((fault) => fault.field === "profile" || fault.field === "facets").map((fault) => ({ ...fault, field: "facets" }))]} onChange={take} />
      <MediaInputs name={name} media={media} kinds={kinds} faults={faults} onChange={(to) => onChange({ ...panel, media: to })} />
    </>
  );
}

function line(facet: Facet): string {
  const rest = facet.film !== undefined ? ` ${facet.bulge ?? 0} ${facet.film}` : facet.bulge ? ` ${facet.bulge}` : "";
  return `${facet.start.map(short).join(" ")}  ${facet.end.map(short).join(" ")}  ${facet.left} ${facet.right}${rest}`;
}

const short = (value: number): string => String(Number(value.toPrecision(12)));

function facetsOf(text: string): { facets: Facet[] | null; line: number } {
  const facets: Facet[] = [];
  const lines = text.split("\n");
  for (let k = 0; k < lines.length; k++) {
    if (!lines[k].trim()) continue;
    const n = lines[k].trim().split(/[\s,;]+/).map(Number);
    if (n.length < 6 || n.length > 8 || !n.every(Number.isFinite)) return { facets: null, line: k + 1 };
    facets.push({ start: [n[0], n[1]], end: [n[2], n[3]], left: n[4], right: n[5], ...(n[6] ? { bulge: n[6] } : {}), ...(n.length > 7 ? { film: n[7] } : {}) });
  }
  return { facets, line: 0 };
}
