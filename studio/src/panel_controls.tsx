// The controls of one panel: its kind, sizes and medium.

import type { Kinds } from "./answers";
import type { Fault } from "./ask";
import { ChoiceInput, Faults, SliderInput } from "./inputs";
import type { Panel } from "./state";
import { words } from "./words";

interface Props {
  name: string;
  title: string;
  panel: Panel;
  kinds: Kinds;
  faults: Fault[];
  onChange: (panel: Panel) => void;
}

export function PanelControls({ name, title, panel, kinds, faults, onChange }: Props) {
  const kind = kinds.kinds.find((one) => one.kind === panel.kind);
  const turn = (word: string) => {
    const to = kinds.kinds.find((one) => one.kind === word);
    if (!to) return;
    const sizes = Object.fromEntries(to.sliders.map((slider) => [slider.name, typeof panel[slider.name] === "number" ? panel[slider.name] : slider.start]));
    const choices = Object.fromEntries(to.choices.map((choice) => [choice.name, choice.start]));
    onChange({ kind: to.kind, ...sizes, ...choices, medium: to.medium });
  };
  const isNamed = panel.medium === undefined || typeof panel.medium === "string";
  const medium = typeof panel.medium === "string" ? panel.medium : (kind?.medium ?? "");
  const fields = [...(kind?.sliders.map((slider) => slider.name) ?? [])];
  const kindOptions = kinds.kinds.map((one): [string, string] => [one.kind, words.kinds[one.kind] ?? one.kind]);
  if (!kind) kindOptions.push([panel.kind, words.kinds[panel.kind] ?? panel.kind]);
  return (
    <fieldset class="controls">
      <legend>{title}</legend>
      <ChoiceInput id={`${name}-kind`} label={words.fields.kind} value={panel.kind} options={kindOptions} onChange={turn} />
      {kind?.sliders.map((slider) => {
        const value = panel[slider.name];
        if (value !== undefined && value !== null && typeof value !== "number")
          return (
            <p key={slider.name} class="hint">
              {words.fields[slider.name]}: {String(value)} {slider.unit} ({words.custom})
            </p>
          );
        return (
          <SliderInput
            key={slider.name}
            id={`${name}-${slider.name}`}
            field={slider.name}
            label={words.fields[slider.name] ?? slider.name}
            value={typeof value === "number" ? value : slider.start}
            low={Math.min(slider.low, typeof value === "number" ? value : slider.low)}
            high={Math.max(slider.high, typeof value === "number" ? value : slider.high)}
            step={slider.step}
            unit={slider.unit}
            faults={faults}
            onChange={(to) => onChange({ ...panel, [slider.name]: to })}
          />
        );
      })}
      {kind?.choices.map((choice) => (
        <ChoiceInput
          key={choice.name}
          id={`${name}-${choice.name}`}
          label={words.fields[choice.name] ?? choice.name}
          value={String(panel[choice.name] ?? choice.start)}
          options={choice.words.map((word) => [word, words.choices[word] ?? word])}
          onChange={(to) => onChange({ ...panel, [choice.name]: to })}
        />
      ))}
      {kind && (
        <ChoiceInput
          id={`${name}-medium`}
          label={words.fields.medium}
          value={isNamed ? medium : "custom"}
          options={[...kinds.media.map((word): [string, string] => [word, words.media[word] ?? word]), ...(isNamed ? [] : ([["custom", words.custom]] as [string, string][]))]}
          onChange={(to) => onChange({ ...panel, medium: to })}
        />
      )}
      <Faults faults={faults} fields={fields} />
    </fieldset>
  );
}
