// The panel: its section with the beams, its shares, how they depend on the sun, two side by side.

import { useState } from "preact/hooks";
import { chosen, Faults } from "../parts/inputs";
import { saveFile } from "../parts/save";
import type { About, Kinds } from "../server/answers";
import { ask, type Fault, Refused } from "../server/ask";
import { useOnce } from "../server/follow";
import { change, type Panel, type State } from "../state/state";
import { words } from "../words/page";
import { panel as said } from "../words/panel";
import { CompareButtons, Differences } from "./compare";
import { PanelControls } from "./controls";
import { CurveFigures, DispersionFigure } from "./figures";
import { type Looked, useLooked } from "./follow";
import { KlemsFigure } from "./klems";
import { OnePanel } from "./one";
import "./panel.css";
import { setSun, SunInputs } from "./sun";

export { Progress } from "../parts/progress";

export function PanelView({ state, isDark }: { state: State; isDark: boolean }) {
  const sun = state.panel;
  const kinds = useOnce<Kinds>("/api/panel/kinds");
  const about = useOnce<About>("/api/about");
  const [fileFaults, setFileFaults] = useState<Fault[]>([]);
  const [follows, setFollows] = useState({ a: false, b: false });
  const a = useLooked(sun.a, sun, true, follows.a);
  const b = useLooked(sun.b, sun, sun.compares, follows.b);
  const names = (sun.compares ? ["a", "b"] : ["a"]) as ("a" | "b")[];
  const looked = { a, b };
  const drawings = about.value?.files.filter((file) => file.kind === "drawing").map((file) => file.path) ?? [];
  return (
    <div class={`view panelView${sun.compares ? " compares" : ""}`}>
      <aside class="side" aria-label={words.panel}>
        {kinds.value &&
          names.map((name) => (
            <PanelControls
              key={name}
              name={name}
              title={sun.compares ? words.panelNames[name] : words.panel}
              panel={sun[name]}
              kinds={kinds.value as Kinds}
              drawings={drawings}
              faults={faultsOf(looked[name])}
              onChange={(panel) => change("panel", { [name]: panel })}
            />
          ))}
        <Faults faults={kinds.faults} />
        <SunInputs sun={sun} />
        <CompareButtons sun={sun} />
        <Files names={names} state={state} onFaults={setFileFaults} />
        <Faults faults={fileFaults} />
      </aside>
      <div class="main">
        <div class={sun.compares ? "two" : "one"}>
          {names.map((name) => (
            <OnePanel key={name} name={name} looked={looked[name]} state={state} isDark={isDark} onSun={setSun} />
          ))}
        </div>
        {sun.compares && <Differences a={a} b={b} />}
        <div class="grid">
          <CurveFigures names={names} looked={looked} state={state} />
          {names.map((name) => (
            <DispersionFigure key={name} name={name} names={names} looked={looked[name]} state={state} follows={follows[name]} onFollow={(does) => setFollows({ ...follows, [name]: does })} />
          ))}
          {names.map((name) => (
            <KlemsFigure key={name} name={name} title={`${said.klemsTitle}${sun.compares ? `: ${words.panelNames[name]}` : ""}`} looked={looked[name]} state={state} />
          ))}
        </div>
      </div>
    </div>
  );
}

/** What is wrong with a panel, each message once. */
function faultsOf(looked: Looked): Fault[] {
  return [...looked.section.faults, ...looked.lobes.faults].filter((fault, k, all) => all.findIndex((one) => one.message === fault.message) === k);
}

function Files({ names, state, onFaults }: { names: ("a" | "b")[]; state: State; onFaults: (faults: Fault[]) => void }) {
  const open = async (file: File | undefined, name: "a" | "b") => {
    if (!file) return;
    try {
      const { panel } = await ask<{ panel: Panel }>("/api/panel/read", { text: await file.text() });
      onFaults([]);
      change("panel", { [name]: panel });
    } catch (fault) {
      onFaults([{ field: null, message: `${words.badFile}: ${(fault as Refused).message}` }]);
    }
  };
  const save = async (panel: Panel, name: string) => {
    try {
      saveFile(names.length > 1 ? `panel-${name}.toml` : "panel.toml", (await ask<{ text: string }>("/api/panel/toml", { panel })).text, "application/toml");
      onFaults([]);
    } catch (fault) {
      onFaults((fault as Refused).faults ?? []);
    }
  };
  return (
    <div class="files">
      {names.map((name) => (
        <label key={name} class="button">
          {names.length > 1 ? said.openInto(name.toUpperCase()) : said.openToml}
          <input type="file" accept=".toml" onChange={(event) => void open(chosen(event), name)} />
        </label>
      ))}
      {names.map((name) => (
        <button key={name} onClick={() => void save(state.panel[name], name)}>
          {said.saveToml}
          {names.length > 1 ? ` ${name.toUpperCase()}` : ""}
        </button>
      ))}
    </div>
  );
}
