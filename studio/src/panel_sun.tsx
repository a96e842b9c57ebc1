// Where the light comes from: a sky to drag the sun in, sliders, the side.

import { DrawSky } from "./draw_sky";
import { ChoiceInput, SliderInput } from "./inputs";
import type { PanelState } from "./panel_state";
import { change } from "./state";
import { words } from "./words";
import { panel as said } from "./words/panel";

const clamp = (deg: number): number => Math.round(10 * Math.min(89, Math.max(-89, deg))) / 10;

export function setSun(elevation: number, azimuth?: number) {
  change("panel", { elevation: clamp(elevation), ...(azimuth === undefined ? {} : { azimuth: clamp(azimuth) }) });
}

export function SunInputs({ sun }: { sun: PanelState }) {
  return (
    <fieldset class="controls">
      <legend>{said.sun}</legend>
      <DrawSky elevation={sun.elevation} azimuth={sun.azimuth} side={sun.side} label={said.skyLabel} text={said.skyText(sun.elevation, sun.azimuth)} up={words.up} right={words.right} onSun={setSun} />
      <SliderInput id="elevation" label={said.elevation} value={sun.elevation} low={-89} high={89} step={0.5} unit="°" onChange={(elevation) => setSun(elevation)} />
      <SliderInput id="azimuth" label={said.azimuth} value={sun.azimuth} low={-89} high={89} step={0.5} unit="°" onChange={(azimuth) => setSun(sun.elevation, azimuth)} />
      <ChoiceInput id="side" label={said.side} value={sun.side} options={Object.entries(said.sides)} onChange={(side) => change("panel", { side })} />
    </fieldset>
  );
}
