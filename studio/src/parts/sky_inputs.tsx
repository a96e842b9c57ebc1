// Where the light comes from: a sky to drag the sun in, and its two angles.

import { DrawSky } from "../draw/sky";
import { words } from "../words/page";
import { panel as said } from "../words/panel";
import { SliderInput } from "./inputs";

interface Props {
  elevation: number;
  azimuth: number;
  side: string;
  /** Of the sliders [deg]. */
  step: number;
  onSun: (elevation: number, azimuth: number) => void;
}

export function SkyInputs({ elevation, azimuth, side, step, onSun }: Props) {
  const angle = { low: -89, high: 89, step, unit: "°" };
  return (
    <>
      <DrawSky elevation={elevation} azimuth={azimuth} side={side} label={said.skyLabel} text={said.skyText(elevation, azimuth)} up={words.up} right={words.right} onSun={onSun} />
      <SliderInput id="elevation" label={said.elevation} value={elevation} {...angle} onChange={(to) => onSun(to, azimuth)} />
      <SliderInput id="azimuth" label={said.azimuth} value={azimuth} {...angle} onChange={(to) => onSun(elevation, to)} />
    </>
  );
}
