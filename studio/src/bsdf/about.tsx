// What a BSDF is, and what its checks say in plain words.

import { Heads } from "../parts/data_table";
import type { BsdfTold } from "../server/answers";
import { words } from "../words/page";

export function BsdfAbout({ told }: { told: BsdfTold }) {
  return (
    <section class="figure about" aria-label={told.name}>
      <h2>{told.name}</h2>
      <p>
        {told.manufacturer}, {words.thickness} {told.thickness_mm === null ? words.unknown : `${told.thickness_mm} mm`}
      </p>
      <h3>{words.findings}</h3>
      <ul class="findings">
        {told.findings.map((finding, k) => (
          <li key={k} class={finding.severity}>
            <b>{words.severity[finding.severity]}</b> {finding.where}: {finding.text}
          </li>
        ))}
        {!told.findings.some((finding) => finding.severity !== "note") && <li class="sound">{words.noFindings}</li>}
      </ul>
      {told.assumed.length > 0 && (
        <>
          <h3>{words.assumed}</h3>
          <ul>
            {told.assumed.map((text) => (
              <li key={text}>{text}</li>
            ))}
          </ul>
        </>
      )}
      <details>
        <summary>{words.blocks}</summary>
        <table>
          <Heads words={words.blockHeads} />
          <tbody>
            {Object.entries(told.bands).flatMap(([band, blocks]) =>
              Object.entries(blocks).map(([name, block]) => (
                <tr key={band + name}>
                  <td>
                    {words.directions[name]}, {band}
                  </td>
                  <td>{block.normal.toFixed(4)}</td>
                  <td>{block.mean.toFixed(4)}</td>
                  <td>{block.most.toFixed(4)}</td>
                </tr>
              )),
            )}
          </tbody>
        </table>
      </details>
    </section>
  );
}
