// Shares of BSDFs against elevation.

import { HUES } from "./colours";

export interface Curve {
  word: string;
  name: string;
  isSecond: boolean;
  elevation_deg: number[];
  values: number[];
}

const [WIDE, HIGH, LEFT, FOOT, HEAD] = [560, 320, 44, 40, 44];
const LINES: Record<string, string> = { Transmitted: HUES.transmittance, Reflected: HUES.reflectance };

export function DrawCurve({ curves, elevation, axis, label }: { curves: Curve[]; elevation: number; axis: string; label: string }) {
  const x = (deg: number) => LEFT + ((deg + 90) / 180) * (WIDE - LEFT - 14);
  const y = (share: number) => HIGH - FOOT - share * (HIGH - FOOT - HEAD);
  return (
    <svg class="drawing" viewBox={`0 0 ${WIDE} ${HIGH}`} role="img" aria-label={label}>
      {[0, 0.25, 0.5, 0.75, 1].map((share) => (
        <g key={share}>
          <path class="hair" d={`M${LEFT} ${y(share)}H${WIDE - 14}`} />
          <text class="small" x={LEFT - 6} y={y(share)} text-anchor="end" dominant-baseline="central">
            {100 * share}
          </text>
        </g>
      ))}
      {[-90, -60, -30, 0, 30, 60, 90].map((deg) => (
        <text key={deg} class="small" x={x(deg)} y={HIGH - FOOT + 15} text-anchor="middle">
          {deg}°
        </text>
      ))}
      <text class="small faint" x={(WIDE + LEFT) / 2} y={HIGH - 6} text-anchor="middle">
        {axis}
      </text>
      <text class="small faint" x={LEFT - 6} y={HEAD - 14} text-anchor="end">
        %
      </text>
      {curves.map((curve) => (
        <path key={curve.name + curve.word} class="curve" stroke={LINES[curve.word]} stroke-dasharray={curve.isSecond ? "6 4" : ""} d={`M${curve.elevation_deg.map((deg, k) => `${x(deg).toFixed(1)} ${y(curve.values[k]).toFixed(1)}`).join("L")}`} />
      ))}
      <path class="here" d={`M${x(elevation)} ${y(0)}V${y(1)}`} />
      {curves.map((curve, k) => (
        <g key={curve.name + curve.word}>
          <path class="curve" stroke={LINES[curve.word]} stroke-dasharray={curve.isSecond ? "6 4" : ""} d={`M${LEFT + (k % 2) * 250} ${12 + 18 * Math.floor(k / 2)}h22`} />
          <text class="small" x={LEFT + 30 + (k % 2) * 250} y={12 + 18 * Math.floor(k / 2)} dominant-baseline="central">
            {curve.name ? `${curve.word}, ${curve.name}` : curve.word}
          </text>
        </g>
      ))}
    </svg>
  );
}
