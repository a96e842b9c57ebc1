// Inputs with their label, unit, and what is wrong beside them.

import type { Fault } from "./ask";
import { words } from "./words";

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
  onChange: (value: number) => void;
}

export function SliderInput({ id, label, value, low, high, step, unit, faults = [], field, onChange }: SliderProps) {
  const wrong = faults.filter((fault) => fault.field === (field ?? id));
  const take = (event: Event) => {
    const number = (event.currentTarget as HTMLInputElement).valueAsNumber;
    if (Number.isFinite(number)) onChange(number);
  };
  return (
    <div class={`input${wrong.length ? " wrong" : ""}`}>
      <label for={id}>{label}</label>
      <span class="number">
        <input type="number" step={step} value={value} aria-label={`${label}, ${unit}`} aria-describedby={wrong.length ? `${id}-wrong` : undefined} aria-invalid={wrong.length > 0} onInput={take} />
        <span class="unit">{unit}</span>
      </span>
      <input id={id} type="range" min={low} max={high} step={step} value={value} aria-valuetext={`${value} ${unit}`} onInput={take} />
      {wrong.length > 0 && (
        <p class="fault" id={`${id}-wrong`} role="alert">
          {wrong.map((fault) => fault.message).join("; ")}
        </p>
      )}
    </div>
  );
}

interface ChoiceProps {
  id: string;
  label: string;
  value: string;
  options: [string, string][];
  onChange: (value: string) => void;
}

export function ChoiceInput({ id, label, value, options, onChange }: ChoiceProps) {
  return (
    <div class="input">
      <label for={id}>{label}</label>
      <select id={id} value={value} onChange={(event) => onChange(event.currentTarget.value)}>
        {options.map(([word, shown]) => (
          <option key={word} value={word}>
            {shown}
          </option>
        ))}
      </select>
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
