// Fields of a panel: a number, one that may be left out, one that may be a list, text.

import { useEffect, useState } from "preact/hooks";
import { FieldFault, Help, SliderInput } from "../parts/inputs";
import type { Slider } from "../server/answers";
import type { Fault } from "../server/ask";
import type { Value } from "../state/state";
import { panel as said } from "../words/panel";

interface Props {
  id: string;
  slider: Slider;
  value: Value | undefined;
  faults: Fault[];
  onChange: (value: Value | undefined) => void;
}

/** A slider; with a switch if its value may be left out, and text instead if it is a list. */
export function SizeInput({ id, slider, value, faults, onChange }: Props) {
  const label = said.fields[slider.name] ?? slider.name;
  const help = said.help[slider.name];
  const isOptional = slider.start === null;
  if (isOptional && (value === undefined || value === null))
    return (
      <div class="input" title={help}>
        <label class="check">
          <input id={id} type="checkbox" checked={false} onChange={() => onChange(slider.sets)} /> {label}
        </label>
        <span class="hint">{said.off}</span>
      </div>
    );
  if (Array.isArray(value))
    return <ListInput id={id} field={slider.name} label={`${label}, ${slider.unit}`} value={value as number[]} help={help} faults={faults} onChange={onChange} onOne={() => onChange((value[0] as number) ?? slider.sets)} />;
  const number = typeof value === "number" ? value : slider.sets;
  const extra = (
    <>
      {isOptional && (
        <button class="link" onClick={() => onChange(undefined)}>
          {said.off}
        </button>
      )}
      {slider.repeats && (
        <button class="link" aria-label={`${label}: ${said.list}`} onClick={() => onChange([number, number])}>
          {said.list}
        </button>
      )}
    </>
  );
  return (
    <SliderInput
      id={id}
      field={slider.name}
      label={label}
      value={number}
      low={Math.min(slider.low, number)}
      high={Math.max(slider.high, number)}
      step={slider.step}
      unit={slider.unit}
      help={help}
      extra={extra}
      faults={faults}
      onChange={onChange}
    />
  );
}

interface ListProps {
  id: string;
  field: string;
  label: string;
  value: number[];
  help?: string;
  faults: Fault[];
  onChange: (value: number[]) => void;
  onOne: () => void;
}

/** Numbers that repeat, as text: what is no number yet changes nothing. */
function ListInput({ id, field, label, value, help, faults, onChange, onOne }: ListProps) {
  const shown = value.join(" ");
  const [text, setText] = useState(shown);
  useEffect(() => {
    if (numbers(text)?.join(" ") !== shown) setText(shown);
  }, [shown]);
  const wrong = faults.filter((fault) => fault.field === field);
  const take = (typed: string) => {
    setText(typed);
    const found = numbers(typed);
    if (found) onChange(found);
  };
  return (
    <div class={`input${wrong.length || !numbers(text) ? " wrong" : ""}`} title={help}>
      <span>
        <label for={id}>{label}</label>
        <button class="link" onClick={onOne}>
          {said.one}
        </button>
      </span>
      <input id={id} class="list" type="text" inputMode="decimal" value={text} aria-describedby={`${id}-help`} aria-invalid={wrong.length > 0} onInput={(event) => take(event.currentTarget.value)} />
      <Help id={id} text={`${said.listHelp}. ${help ?? ""}`} />
      <FieldFault id={id} faults={wrong} />
    </div>
  );
}

function numbers(text: string): number[] | null {
  const found = text.trim().split(/[\s,;]+/).map(Number);
  return text.trim() && found.every(Number.isFinite) ? found : null;
}

interface TextProps {
  id: string;
  field: string;
  label: string;
  value: string;
  rows: number;
  help?: string;
  faults: Fault[];
  onChange: (value: string) => void;
}

export function TextInput({ id, field, label, value, rows, help, faults, onChange }: TextProps) {
  const wrong = faults.filter((fault) => fault.field === field);
  return (
    <div class={`input text${wrong.length ? " wrong" : ""}`}>
      <label for={id}>{label}</label>
      <textarea id={id} rows={rows} spellcheck={false} value={value} aria-describedby={`${id}-help`} aria-invalid={wrong.length > 0} onInput={(event) => onChange(event.currentTarget.value)} />
      <Help id={id} text={help} />
      <FieldFault id={id} faults={wrong} />
    </div>
  );
}
