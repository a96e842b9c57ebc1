// The numbers of a figure as a table, for whoever does not see the picture.

import { useState } from "preact/hooks";
import { said } from "./ticks";

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
            <thead>
              <tr>
                {names.map((name) => (
                  <th key={name} scope="col">
                    {name.replace(/_/g, " ")}
                  </th>
                ))}
              </tr>
            </thead>
            <tbody>
              {Array.from({ length: rows }, (_, k) => (
                <tr key={k}>
                  {names.map((name) => {
                    const value = columns[name][k];
                    return <td key={name}>{typeof value === "string" ? value : said(value)}</td>;
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
