// The sun on the panel, and the side that it is on.

import { ChoiceInput } from "../parts/inputs";
import { SkyInputs } from "../parts/sky_inputs";
import { change } from "../state/state";
import { panel as said } from "../words/panel";
import type { PanelState } from "./state";

const clamp = (deg: number): number => Math.round(10 * Math.min(89, Math.max(-89, deg))) / 10;

export function setSun(elevation: number, azimuth?: number) {
  change("panel", { elevation: clamp(elevation), ...(azimuth === undefined ? {} : { azimuth: clamp(azimuth) }) });
}

export function SunInputs({ sun }: { sun: PanelState }) {
  return (
    <fieldset class="controls">
      <legend>{said.sun}</legend>
      <SkyInputs elevation={sun.elevation} azimuth={sun.azimuth} side={sun.side} step={0.5} onSun={setSun} />
      <ChoiceInput id="side" label={said.side} value={sun.side} options={Object.entries(said.sides)} onChange={(side) => change("panel", { side })} />
    </fieldset>
  );
}
