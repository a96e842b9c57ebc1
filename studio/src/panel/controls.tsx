// The controls of one panel: where to start from, its kind, sizes and medium.

import { ChoiceInput, Faults } from "../parts/inputs";
import type { Kinds, Slider } from "../server/answers";
import type { Fault } from "../server/ask";
import type { Panel, Value } from "../state/state";
import { panel as said } from "../words/panel";
import { DrawnInputs, FacetInputs } from "./drawn";
import { SizeInput } from "./fields";
import { MediumInput } from "./medium";

interface Props {
  name: string;
  title: string;
  panel: Panel;
  kinds: Kinds;
  drawings: string[];
  faults: Fault[];
  onChange: (panel: Panel) => void;
}

export function PanelControls({ name, title, panel, kinds, drawings, faults, onChange }: Props) {
  const kind = kinds.kinds.find((one) => one.kind === panel.kind);
  const isDrawn = panel.kind === "drawn";
  const turn = (word: string) => {
    const to = kinds.kinds.find((one) => one.kind === word);
    if (!to) return;
    const sizes = Object.fromEntries(to.sliders.filter((slider) => slider.start !== null).map((slider) => [slider.name, typeof panel[slider.name] === "number" ? panel[slider.name] : (slider.start as number)]));
    const choices = Object.fromEntries(to.choices.map((choice) => [choice.name, choice.start]));
    const texts = Object.fromEntries(to.texts.map((text) => [text.name, text.start]));
    onChange({ kind: to.kind, ...sizes, ...choices, ...texts, ...(word === "drawn" ? { media: [to.medium] } : { medium: to.medium }) });
  };
  const set = (field: string, value: Value | undefined) => {
    const { [field]: _, ...rest } = panel;
    onChange((value === undefined ? rest : { ...panel, [field]: value }) as Panel);
  };
  const size = (slider: Slider) => <SizeInput key={slider.name} id={`${name}-${slider.name}`} slider={slider} value={panel[slider.name]} faults={faults} onChange={(value) => set(slider.name, value)} />;
  const kindOptions = kinds.kinds.map((one): [string, string] => [one.kind, said.kinds[one.kind] ?? one.kind]);
  if (!kind) kindOptions.push([panel.kind, said.kinds[panel.kind] ?? panel.kind]);
  const groups = [...new Set(kind?.sliders.map((slider) => slider.group).filter(Boolean))];
  const isSet = (slider: Slider) => panel[slider.name] !== undefined && panel[slider.name] !== slider.start;
  const shown = ["n", "absorption_per_mm", "points", "path_data", "facets", "profile", ...(kind?.sliders.map((slider) => slider.name) ?? [])];
  return (
    <fieldset class="controls panelControls">
      <legend>{title}</legend>
      <Presets name={name} kinds={kinds} onChange={onChange} />
      <ChoiceInput id={`${name}-kind`} label={said.fields.kind} value={panel.kind} options={kindOptions} onChange={turn} />
      {kind?.sliders.filter((slider) => !slider.group).map(size)}
      {kind?.choices.map((choice) => (
        <ChoiceInput
          key={choice.name}
          id={`${name}-${choice.name}`}
          label={said.fields[choice.name] ?? choice.name}
          value={String(panel[choice.name] ?? choice.start)}
          options={choice.words.map((word) => [word, said.choices[word] ?? word])}
          help={said.help[choice.name]}
          onChange={(to) => set(choice.name, to)}
        />
      ))}
      {isDrawn && <DrawnInputs name={name} panel={panel} kinds={kinds} drawings={drawings} faults={faults} onChange={onChange} />}
      {panel.kind === "extruded" && panel.profile && <FacetInputs name={name} panel={panel} kinds={kinds} faults={faults} onChange={onChange} />}
      {kind && !isDrawn && <MediumInput id={`${name}-medium`} label={said.fields.medium} value={panel.medium} start={kind.medium} media={kinds.media} faults={faults} onChange={(to) => set("medium", to)} />}
      {groups.map((group) => {
        const own = kind?.sliders.filter((slider) => slider.group === group) ?? [];
        return (
          <details key={`${panel.kind}-${group}`} class="fold" open={own.some(isSet)}>
            <summary>{said.groups[group] ?? group}</summary>
            {own.map(size)}
          </details>
        );
      })}
      <Faults faults={faults} fields={shown} />
    </fieldset>
  );
}

/** Panels to start from, one click each. */
function Presets({ name, kinds, onChange }: { name: string; kinds: Kinds; onChange: (panel: Panel) => void }) {
  const groups = [...new Set(kinds.presets.map((one) => one.group))];
  return (
    <div class="chips" role="group" aria-label={`${said.startFrom}, ${name.toUpperCase()}`}>
      {groups.map((group) => (
        <span key={group} title={group === "laser-cut" ? said.presetHint : undefined}>
          <i>{said.presets[group] ?? group}</i>
          {kinds.presets
            .filter((one) => one.group === group)
            .map((one) => (
              <button key={one.name} aria-label={`${said.startFrom} ${said.presets[group] ?? group} ${one.name}`} onClick={() => onChange(structuredClone(one.panel) as Panel)}>
                {one.name}
              </button>
            ))}
        </span>
      ))}
    </div>
  );
}
