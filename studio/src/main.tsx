// The page: its tabs and the view that is open.

import { Fragment, render } from "preact";
import type { FunctionComponent } from "preact";
import { useEffect, useState } from "preact/hooks";
import { BsdfView } from "./bsdf/view";
import { PanelView } from "./panel/view";
import { useIsDark, useStudio, useTimesBack } from "./server/follow";
import { Header } from "./shell/header";
import type { State } from "./state/state";
import "./style.css";
import { words } from "./words/page";

const VIEWS = ["panel", "room", "year", "bsdf"];

/** Views that are large come when they are opened. */
const LATER: Record<string, () => Promise<FunctionComponent<{ state: State; isDark: boolean }>>> = {
  room: async () => (await import("./room/view")).RoomView,
  year: async () => (await import("./year/view")).YearView,
};

function Later({ name, state, isDark }: { name: string; state: State; isDark: boolean }) {
  const [View, setView] = useState<{ is: FunctionComponent<{ state: State; isDark: boolean }> } | null>(null);
  useEffect(() => void LATER[name]().then((is) => setView({ is })), [name]);
  return View ? <View.is state={state} isDark={isDark} /> : <p class="hint big">{words.working} …</p>;
}

function Page() {
  const state = useStudio();
  const isDark = useIsDark(state.theme);
  const times = useTimesBack();
  const view = VIEWS.includes(state.view) ? state.view : VIEWS[0];
  useEffect(() => {
    document.documentElement.dataset.theme = isDark ? "dark" : "light";
    document.title = `${words.views[view]} · ${words.title}`;
  }, [isDark, view]);
  return (
    <>
      <Header state={state} views={VIEWS} view={view} />
      <main id="view" tabIndex={-1}>
        <div id="tabpanel" role="tabpanel" aria-labelledby={`tab-${view}`}>
          <h2 class="unseen">{words.views[view]}</h2>
          {/* a studio that was started again holds nothing of before: the view asks anew */}
          <Fragment key={times}>
            {view === "panel" && <PanelView state={state} isDark={isDark} />}
            {view in LATER && <Later key={view} name={view} state={state} isDark={isDark} />}
            {view === "bsdf" && <BsdfView state={state} />}
          </Fragment>
        </div>
      </main>
    </>
  );
}

render(<Page />, document.getElementById("app") as HTMLElement);
