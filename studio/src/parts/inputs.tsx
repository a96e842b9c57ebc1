// Inputs with their label, unit, and what is wrong beside them.

import type { ComponentChildren } from "preact";
import type { Fault } from "../server/ask";
import { words } from "../words/page";

interface SliderProps {
  id: string;
  label: string;
  value: number;
  low: number;
  high: number;
  step: number;
  unit: string;
  faults?: Fault[];
  field?: string;
  help?: string;
  extra?: ComponentChildren;
  onChange: (value: number) => void;
}

export function SliderInput({ id, label, value, low, high, step, unit, faults = [], field, help, extra, onChange }: SliderProps) {
  const wrong = faults.filter((fault) => fault.field === (field ?? id));
  const take = (event: Event) => {
    const number = (event.currentTarget as HTMLInputElement).valueAsNumber;
    if (Number.isFinite(number)) onChange(number);
  };
  return (
    <div class={`input${wrong.length ? " wrong" : ""}`} title={help}>
      <span>
        <label for={id}>{label}</label>
        {extra}
      </span>
      <span class="number">
        <input type="number" step={step} value={value} aria-label={unit ? `${label}, ${unit}` : label} aria-describedby={wrong.length ? `${id}-wrong` : help ? `${id}-help` : undefined} aria-invalid={wrong.length > 0} onInput={take} />
        <span class="unit">{unit}</span>
      </span>
      <input id={id} type="range" min={low} max={high} step={step} value={value} aria-valuetext={`${value} ${unit}`} onInput={take} />
      <Help id={id} text={help} />
      <FieldFault id={id} faults={wrong} />
    </div>
  );
}

/** What is wrong with an input. */
export function FieldFault({ id, faults }: { id: string; faults: Fault[] }) {
  if (!faults.length) return null;
  return (
    <p class="fault" id={`${id}-wrong`} role="alert">
      {faults.map((fault) => fault.message).join("; ")}
    </p>
  );
}

/** A sentence about an input, shown while it has the focus. */
export function Help({ id, text }: { id: string; text?: string }) {
  return text ? (
    <p class="help" id={`${id}-help`}>
      {text}
    </p>
  ) : null;
}

interface ChoiceProps {
  id: string;
  label: string;
  value: string;
  options: [string, string][];
  help?: string;
  /** What to call it for those who do not see it, where no label stands beside it. */
  name?: string;
  onChange: (value: string) => void;
}

export function ChoiceInput({ id, label, value, options, help, name, onChange }: ChoiceProps) {
  return (
    <div class="input" title={help}>
      {label && <label for={id}>{label}</label>}
      <select id={id} value={value} aria-label={label ? undefined : name} aria-describedby={help ? `${id}-help` : undefined} onChange={(event) => onChange(event.currentTarget.value)}>
        {options.map(([word, shown]) => (
          <option key={word} value={word}>
            {shown}
          </option>
        ))}
      </select>
      <Help id={id} text={help} />
    </div>
  );
}

/** What is wrong and no field's own. */
export function Faults({ faults, fields = [] }: { faults: Fault[]; fields?: string[] }) {
  const own = faults.filter((fault) => !fault.field || !fields.includes(fault.field));
  if (!own.length) return null;
  return (
    <p class="fault" role="alert">
      {own.map((fault) => (fault.message === "offline" ? words.offline : fault.message)).join("; ")}
    </p>
  );
}

/** The file that was chosen; the same one can be chosen again once it was changed. */
export function chosen(event: { currentTarget: HTMLInputElement }): File | undefined {
  const file = event.currentTarget.files?.[0];
  event.currentTarget.value = "";
  return file;
}
