// Two panels side by side: what differs, in numbers; swapped and copied.

import { Heads } from "../parts/data_table";
import { Figure } from "../parts/save";
import { change } from "../state/state";
import { words } from "../words/page";
import { panel as said } from "../words/panel";
import type { Looked } from "./follow";
import { sharesOf } from "./one";
import type { PanelState } from "./state";

const ROWS = ["transmittance", "transmittance_deflected", "transmittance_undeflected", "reflectance", "absorptance", "residual"];

export function CompareButtons({ sun }: { sun: PanelState }) {
  return (
    <div class="files">
      <label class="check">
        <input type="checkbox" checked={sun.compares} onChange={(event) => change("panel", { compares: event.currentTarget.checked })} /> {said.compare}
      </label>
      {sun.compares && (
        <>
          <button onClick={() => change("panel", { a: sun.b, b: sun.a })}>{said.swap}</button>
          <button onClick={() => change("panel", { b: structuredClone(sun.a) })}>{said.copyAToB}</button>
        </>
      )}
    </div>
  );
}

export function Differences({ a, b }: { a: Looked; b: Looked }) {
  const [one, other] = [sharesOf(a), sharesOf(b)];
  if (!one.shares || !other.shares) return null;
  const [first, second] = [one.shares, other.shares];
  const rows = ROWS.filter((name) => name !== "residual" || Math.max(first.residual, second.residual) >= 5e-4);
  const error = (name: string) => Math.hypot(one.errors?.[name] ?? 0, other.errors?.[name] ?? 0);
  const table = () => ({ share: rows, a: rows.map((name) => first[name]), b: rows.map((name) => second[name]), b_minus_a: rows.map((name) => second[name] - first[name]), standard_error: rows.map(error) });
  return (
    <Figure name="differences" title={said.differences} table={table} noPicture>
      <table class="differences">
        <Heads words={said.differenceHeads} />
        <tbody>
          {rows.map((name) => {
            const by = 100 * (second[name] - first[name]);
            return (
              <tr key={name}>
                <th scope="row">{words.share[name]}</th>
                <td>{(100 * first[name]).toFixed(1)} %</td>
                <td>{(100 * second[name]).toFixed(1)} %</td>
                <td data-difference={name}>
                  {`${by < 0 ? "−" : "+"}${Math.abs(by).toFixed(1)}`}
                  {error(name) > 5e-4 ? <small> ± {(100 * error(name)).toFixed(1)}</small> : null}
                </td>
              </tr>
            );
          })}
        </tbody>
      </table>
    </Figure>
  );
}
