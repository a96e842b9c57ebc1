// Shares of BSDFs against elevation.

import { axesOf, Here, LineKey, lineOf, ShareAxes } from "./axes";
import { OF_BLOCK } from "./colours";

export interface Curve {
  word: string;
  name: string;
  isSecond: boolean;
  elevation_deg: number[];
  values: number[];
}

export function DrawCurve({ curves, elevation, axis, label }: { curves: Curve[]; elevation: number; axis: string; label: string }) {
  const axes = axesOf(320);
  const drawn = curves.map((curve) => ({ ...curve, key: curve.name + curve.word, stroke: OF_BLOCK[curve.word], dash: curve.isSecond ? "6 4" : "" }));
  return (
    <svg class="drawing" viewBox={`0 0 ${axes.wide} ${axes.high}`} role="img" aria-label={label}>
      <ShareAxes axes={axes} axis={axis} />
      {drawn.map((curve) => (
        <path key={curve.key} class="curve" stroke={curve.stroke} stroke-dasharray={curve.dash} d={lineOf(axes, curve.elevation_deg, curve.values)} />
      ))}
      <Here axes={axes} elevation={elevation} />
      {drawn.map((curve, k) => (
        <LineKey key={curve.key} x={axes.left + 10 + (k % 2) * 250} y={12 + 18 * Math.floor(k / 2)} length={22} stroke={curve.stroke} dash={curve.dash} text={curve.name ? `${curve.word}, ${curve.name}` : curve.word} />
      ))}
    </svg>
  );
}
