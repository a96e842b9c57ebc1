// Anybody's BSDF: dropped or opened, looked at, checked in plain words; two of them compared.

import "../panel/panel.css";
import { useDrop } from "../parts/drop";
import { ChoiceInput, chosen, Faults, SliderInput } from "../parts/inputs";
import { SkyInputs } from "../parts/sky_inputs";
import type { About } from "../server/answers";
import { useOnce } from "../server/follow";
import { change, type State } from "../state/state";
import { bsdf as said } from "../words/bsdf";
import { words } from "../words/page";
import { BsdfAbout } from "./about";
import { BsdfNumbers } from "./numbers";
import { BsdfFigures, useLookedAt } from "./one";
import { type Opened, type Slot, useOpened } from "./open";
import type { BsdfState } from "./state";

export function BsdfView({ state }: { state: State }) {
  const look = state.bsdf;
  const about = useOnce<About>("/api/about");
  const a = useOpened("a", look);
  const b = useOpened("b", look);
  const opened = { a, b };
  const slots: Slot[] = look.compares ? ["a", "b"] : ["a"];
  const looked = { a: useLookedAt(a.key, look), b: useLookedAt(look.compares ? b.key : "", look) };
  const open = slots.filter((slot) => opened[slot].told);
  const files = about.value?.files.filter((file) => file.kind === "bsdf").map((file) => file.path) ?? [];
  // what is dropped goes where nothing is yet
  const free: Slot = look.compares && a.key && !b.key ? "b" : "a";
  const { isOver, hands } = useDrop((held) => void opened[free].drop(held?.files[0]));
  return (
    <div class={`view bsdfView${look.compares ? " compares" : ""}`} {...hands}>
      <aside class="side" aria-label={words.views.bsdf}>
        {slots.map((slot) => (
          <OpenInputs key={slot} slot={slot} opened={opened[slot]} files={files} look={look} isOver={isOver && slot === free} />
        ))}
        <label class="check">
          <input type="checkbox" checked={look.compares} onChange={(event) => change("bsdf", { compares: event.currentTarget.checked })} /> {said.compare}
        </label>
        {open.length > 0 && <LightInputs look={look} bands={Object.keys(opened[open[0]].told?.bands ?? {})} />}
      </aside>
      <div class="main">
        {!open.length && <p class="figure empty">{said.nothing}</p>}
        {open.length > 0 && (
          <>
            <div class={open.length > 1 ? "two" : "one"}>{open.map((slot) => opened[slot].told && <BsdfAbout key={slot} told={opened[slot].told} />)}</div>
            <BsdfNumbers keys={open.map((slot) => opened[slot].key)} discs={open.map((slot) => looked[slot].discs)} look={look} />
            <div class={open.length > 1 ? "two" : "one"}>
              {open.map((slot) => {
                const told = opened[slot].told;
                return (
                  told && (
                    <div key={slot} class="column" data-slot={slot}>
                      <BsdfFigures slot={slot} told={told} look={look} looked={looked[slot]} />
                    </div>
                  )
                );
              })}
            </div>
          </>
        )}
      </div>
    </div>
  );
}

function OpenInputs({ slot, opened, files, look, isOver }: { slot: Slot; opened: Opened; files: string[]; look: BsdfState; isOver: boolean }) {
  const path = slot === "a" ? look.path : look.otherPath;
  return (
    <>
      <label class={`dropPlace${isOver ? " over" : ""}`}>
        {look.compares ? said.dropInto(slot) : words.drop}
        <input type="file" accept=".xml,.nc" onChange={(event) => void opened.drop(chosen(event))} />
      </label>
      {files.length > 0 && <ChoiceInput id={slot === "a" ? "file" : "file-b"} label={words.files} value={path} options={[["", words.chooseFile], ...files.map((file): [string, string] => [file, file])]} onChange={opened.choose} />}
      {opened.isReading && (
        <p class="hint" role="status">
          {said.reading}
        </p>
      )}
      <Faults faults={opened.faults} />
    </>
  );
}

function LightInputs({ look, bands }: { look: BsdfState; bands: string[] }) {
  const set = (elevation: number, azimuth: number) => change("bsdf", { elevation, azimuth });
  return (
    <fieldset class="controls">
      <legend>{said.light}</legend>
      <SkyInputs elevation={look.elevation} azimuth={look.azimuth} side={look.side} step={1} onSun={set} />
      <ChoiceInput id="side" label={words.side} value={look.side} options={Object.entries(words.sides)} onChange={(side) => change("bsdf", { side })} />
      <ChoiceInput id="band" label={words.band} value={look.band} options={bands.map((band) => [band, band])} onChange={(band) => change("bsdf", { band })} />
      <ChoiceInput id="scale" label={said.scale} value={look.scale} options={Object.entries(said.scales)} onChange={(scale) => change("bsdf", { scale })} />
      <SliderInput id="plane" label={words.plane} value={look.plane} low={-90} high={90} step={5} unit="°" onChange={(plane) => change("bsdf", { plane })} />
    </fieldset>
  );
}
