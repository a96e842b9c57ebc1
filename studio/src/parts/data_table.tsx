// Tables: the numbers of a figure for whoever does not see the picture, and the heads of any.

import { useState } from "preact/hooks";
import { written } from "../draw/written";

const MOST_ROWS = 400;

export function DataTable({ summary, table }: { summary: string; table: () => Record<string, (number | string | null)[]> }) {
  const [isOpen, setIsOpen] = useState(false);
  const columns = isOpen ? table() : {};
  const names = Object.keys(columns);
  const rows = names.length ? Math.min(columns[names[0]].length, MOST_ROWS) : 0;
  return (
    <details class="asTable" onToggle={(event) => setIsOpen((event.currentTarget as HTMLDetailsElement).open)}>
      <summary>{summary}</summary>
      {isOpen && (
        <div class="tableScroll" tabindex={0} role="group" aria-label={summary}>
          <table>
            <Heads words={names.map((name) => name.replace(/_/g, " "))} />
            <tbody>
              {Array.from({ length: rows }, (_, k) => (
                <tr key={k}>
                  {names.map((name) => {
                    const value = columns[name][k];
                    return <td key={name}>{typeof value === "string" ? value : written(value)}</td>;
                  })}
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
    </details>
  );
}

/** The heads of a table's columns. */
export function Heads({ words }: { words: string[] }) {
  return (
    <thead>
      <tr>
        {words.map((word) => (
          <th key={word} scope="col">
            {word}
          </th>
        ))}
      </tr>
    </thead>
  );
}
