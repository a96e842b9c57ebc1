// The page: its tabs and the view that is open.

import { render } from "preact";
import type { FunctionComponent } from "preact";
import { useEffect, useState } from "preact/hooks";
import { BsdfView } from "./bsdf_view";
import { useIsDark, useStudio } from "./follow";
import { PanelView } from "./panel_view";
import { change, link, type State } from "./state";
import "./style.css";
import { words } from "./words";

const VIEWS = ["panel", "room", "bsdf"];

/** Views with heavy libraries come when they are opened. */
const LATER: Record<string, () => Promise<FunctionComponent<{ state: State; isDark: boolean }>>> = {
  room: async () => (await import("./room_view")).RoomView,
};

function Later({ name, state, isDark }: { name: string; state: State; isDark: boolean }) {
  const [View, setView] = useState<{ is: FunctionComponent<{ state: State; isDark: boolean }> } | null>(null);
  useEffect(() => void LATER[name]().then((is) => setView({ is })), [name]);
  return View ? <View.is state={state} isDark={isDark} /> : <p class="hint big">{words.working} …</p>;
}

function Page() {
  const state = useStudio();
  const isDark = useIsDark(state.theme);
  const [isCopied, setIsCopied] = useState(false);
  const view = VIEWS.includes(state.view) ? state.view : VIEWS[0];
  useEffect(() => {
    document.documentElement.dataset.theme = isDark ? "dark" : "light";
    document.title = `${words.views[view]} · ${words.title}`;
  }, [isDark, view]);
  const turn = (event: KeyboardEvent) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (step === undefined) return;
    const to = VIEWS[(VIEWS.indexOf(view) + step + VIEWS.length) % VIEWS.length];
    change("view", to);
    document.getElementById(`tab-${to}`)?.focus();
  };
  const copy = () => {
    void navigator.clipboard?.writeText(link()).then(() => {
      setIsCopied(true);
      setTimeout(() => setIsCopied(false), 2000);
    });
  };
  return (
    <>
      <header class="top">
        <h1>{words.title}</h1>
        <div role="tablist" aria-label={words.title} onKeyDown={turn}>
          {VIEWS.map((name) => (
            <button key={name} id={`tab-${name}`} role="tab" aria-selected={name === view} aria-controls="view" tabIndex={name === view ? 0 : -1} onClick={() => change("view", name)}>
              {words.views[name]}
            </button>
          ))}
        </div>
        <span class="space" />
        <span role="status" class="hint">
          {isCopied ? words.copied : ""}
        </span>
        <button onClick={copy}>{words.copyLink}</button>
        <select aria-label={words.theme.label} value={state.theme} onChange={(event) => change("theme", event.currentTarget.value)}>
          <option value="auto">{words.theme.auto}</option>
          <option value="light">{words.theme.light}</option>
          <option value="dark">{words.theme.dark}</option>
        </select>
      </header>
      <main id="view" role="tabpanel" aria-labelledby={`tab-${view}`}>
        {view === "panel" && <PanelView state={state} isDark={isDark} />}
        {view in LATER && <Later key={view} name={view} state={state} isDark={isDark} />}
        {view === "bsdf" && <BsdfView state={state} />}
      </main>
    </>
  );
}

render(<Page />, document.getElementById("app") as HTMLElement);
