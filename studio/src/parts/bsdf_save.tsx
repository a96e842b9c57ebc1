// A BSDF that the studio holds as a file of other programs.

import { useState } from "preact/hooks";
import { askBlob, type Fault, Refused } from "../server/ask";
import { bsdf as said } from "../words/bsdf";
import { saveFile } from "./save";

/** Saves the BSDF of a question as NAME.format; with what was wrong the last time. */
export function useBsdfFile(name: string, asked: Record<string, unknown>): { save: (format: string) => void; faults: Fault[] } {
  const [faults, setFaults] = useState<Fault[]>([]);
  const save = async (format: string) => {
    try {
      saveFile(`${name}.${format}`, await askBlob("/api/bsdf/file", { ...asked, format }));
      setFaults([]);
    } catch (fault) {
      setFaults((fault as Refused).faults ?? []);
    }
  };
  return { save: (format) => void save(format), faults };
}

/** The formats to choose from; choosing saves. */
export function FormatChoice({ label, onSave }: { label: string; onSave: (format: string) => void }) {
  return (
    <select aria-label={label} value="" onChange={(event) => event.currentTarget.value && onSave(event.currentTarget.value)}>
      <option value="">{said.files} …</option>
      {Object.entries(said.formats).map(([format, word]) => (
        <option key={format} value={format}>
          {word}
        </option>
      ))}
    </select>
  );
}
