// Elevation at which each beam leaves, wavelength by wavelength.

import type { Dispersion } from "./answers";

const [WIDE, HIGH, LEFT, FOOT] = [560, 300, 44, 40];

/** About the colour that light of a wavelength has, to tell blue from red [nm]. */
function hue(nm: number): string {
  return `hsl(${Math.round(270 - (270 * (Math.min(Math.max(nm, 400), 680) - 400)) / 280)} 85% 48%)`;
}

export function DrawDispersion({ data, axis, across, label, nothing }: { data: Dispersion; axis: string; across: string; label: string; nothing: string }) {
  const beams = data.beams.filter((beam) => beam.side === "back");
  const lows = beams.map((beam) => beam.elevation_deg);
  const low = Math.max(-90, Math.floor((Math.min(...lows) - 4) / 5) * 5);
  const high = Math.min(90, Math.ceil((Math.max(...lows) + 4) / 5) * 5);
  const x = (nm: number) => LEFT + 14 + ((nm - 400) / 300) * (WIDE - LEFT - 34);
  const y = (deg: number) => 12 + ((high - deg) / (high - low)) * (HIGH - FOOT - 20);
  const ticks = beams.length ? Array.from({ length: 5 }, (_, k) => low + ((high - low) * k) / 4) : [];
  return (
    <svg class="drawing" viewBox={`0 0 ${WIDE} ${HIGH}`} role="img" aria-label={label}>
      {ticks.map((deg) => (
        <g key={deg}>
          <path class="hair" d={`M${LEFT} ${y(deg)}H${WIDE - 10}`} />
          <text class="small" x={LEFT - 6} y={y(deg)} text-anchor="end" dominant-baseline="central">
            {Number(deg.toFixed(1))}°
          </text>
        </g>
      ))}
      {[400, 500, 600, 700].map((nm) => (
        <text key={nm} class="small" x={x(nm)} y={HIGH - FOOT + 15} text-anchor="middle">
          {nm}
        </text>
      ))}
      <text class="small faint" x={WIDE / 2} y={HIGH - 4} text-anchor="middle">
        {across} [nm]
      </text>
      <text class="small faint" x={LEFT + 4} y={10}>
        {axis}
      </text>
      {!beams.length && (
        <text class="faint" x={WIDE / 2} y={HIGH / 2} text-anchor="middle">
          {nothing}
        </text>
      )}
      {beams.map((beam, k) => (
        <circle key={k} cx={x(beam.wavelength_nm)} cy={y(beam.elevation_deg)} r={1.5 + 7 * Math.sqrt(beam.power)} fill={hue(beam.wavelength_nm)} fill-opacity={0.85}>
          <title>{`${beam.wavelength_nm} nm: ${beam.elevation_deg.toFixed(2)}°, ${(100 * beam.power).toFixed(1)} %`}</title>
        </circle>
      ))}
    </svg>
  );
}
