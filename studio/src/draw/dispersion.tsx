// Elevation at which each beam leaves, wavelength by wavelength.

import type { Dispersion } from "../server/answers";

const [WIDE, HIGH, LEFT, FOOT, RIGHT] = [560, 320, 44, 40, 118];
/** Beams with a label of their own. */
const LABELS = 6;

/** About the colour that light of a wavelength has, to tell blue from red [nm]. */
function hue(nm: number): string {
  return `hsl(${Math.round(270 - (270 * (Math.min(Math.max(nm, 400), 680) - 400)) / 280)} 85% 45%)`;
}

interface Branch {
  beams: Dispersion["beams"];
  power: number;
}

/** Beams of neighbouring wavelengths that belong together: the nearest in elevation, of about the same power. */
export function branches(beams: Dispersion["beams"]): Branch[] {
  const found: Branch[] = [];
  for (const nm of [...new Set(beams.map((beam) => beam.wavelength_nm))].sort((a, b) => a - b)) {
    const free = new Set(found.filter((branch) => branch.beams[branch.beams.length - 1].wavelength_nm < nm));
    for (const beam of beams.filter((one) => one.wavelength_nm === nm)) {
      let best: Branch | null = null;
      let least = 4;
      for (const branch of free) {
        const last = branch.beams[branch.beams.length - 1];
        const far = Math.abs(last.elevation_deg - beam.elevation_deg) + 2 * Math.abs(Math.log(last.power / beam.power));
        if (far < least) [best, least] = [branch, far];
      }
      if (best) {
        best.beams.push(beam);
        best.power = Math.max(best.power, beam.power);
        free.delete(best);
      } else found.push({ beams: [beam], power: beam.power });
    }
  }
  return found.sort((a, b) => b.power - a.power);
}

interface Props {
  data: Dispersion;
  side: string;
  axis: string;
  across: string;
  label: string;
  nothing: string;
}

export function DrawDispersion({ data, side, axis, across, label, nothing }: Props) {
  const beams = data.beams.filter((beam) => beam.side === side);
  const lows = beams.map((beam) => beam.elevation_deg);
  const low = beams.length ? Math.max(-90, Math.floor((Math.min(...lows) - 2) / 5) * 5) : -90;
  const high = beams.length ? Math.min(90, Math.ceil((Math.max(...lows) + 2) / 5) * 5) : 90;
  const x = (nm: number) => LEFT + 10 + ((nm - 400) / 300) * (WIDE - LEFT - RIGHT - 10);
  const y = (deg: number) => 20 + ((high - deg) / (high - low)) * (HIGH - FOOT - 28);
  const step = [1, 2, 5, 10, 15, 30].find((one) => (high - low) / one <= 8) ?? 30;
  const ticks = Array.from({ length: Math.floor(high / step) - Math.ceil(low / step) + 1 }, (_, k) => (Math.ceil(low / step) + k) * step);
  const strong = branches(beams);
  const labels = apart(strong.slice(0, LABELS).map(({ beams: own, power }) => ({ at: y(own[own.length - 1].elevation_deg), text: `${own[own.length - 1].elevation_deg.toFixed(1)}°, ${(100 * power).toFixed(power < 0.01 ? 1 : 0)} %` })));
  return (
    <svg class="drawing" viewBox={`0 0 ${WIDE} ${HIGH}`} role="img" aria-label={label}>
      {ticks.map((deg) => (
        <g key={deg}>
          <path class="hair" d={`M${LEFT} ${y(deg)}H${WIDE - RIGHT + 6}`} />
          <text class="small" x={LEFT - 6} y={y(deg)} text-anchor="end" dominant-baseline="central">
            {deg}°
          </text>
        </g>
      ))}
      {[400, 500, 600, 700].map((nm) => (
        <text key={nm} class="small" x={x(nm)} y={HIGH - FOOT + 15} text-anchor="middle">
          {nm}
        </text>
      ))}
      <text class="small faint" x={(LEFT + WIDE - RIGHT) / 2} y={HIGH - 6} text-anchor="middle">
        {across} [nm]
      </text>
      <text class="small faint" x={4} y={10}>
        {axis}
      </text>
      {!beams.length && (
        <text class="faint" x={(LEFT + WIDE - RIGHT) / 2} y={HIGH / 2} text-anchor="middle">
          {nothing}
        </text>
      )}
      {strong.map((branch, k) => branch.beams.length > 1 && <path key={k} class="hair thread" d={`M${branch.beams.map((beam) => `${x(beam.wavelength_nm).toFixed(1)} ${y(beam.elevation_deg).toFixed(1)}`).join("L")}`} />)}
      {beams.map((beam, k) => (
        <circle key={k} cx={x(beam.wavelength_nm)} cy={y(beam.elevation_deg)} r={1.5 + 7 * Math.sqrt(beam.power)} fill={hue(beam.wavelength_nm)}>
          <title>{`${beam.wavelength_nm} nm: ${beam.elevation_deg.toFixed(2)}°, ${(100 * beam.power).toFixed(1)} %`}</title>
        </circle>
      ))}
      {labels.map(({ at, text }) => (
        <text key={text} class="small" x={WIDE - RIGHT + 14} y={at} dominant-baseline="central">
          {text}
        </text>
      ))}
    </svg>
  );
}

/** Labels moved so that none lies on another. */
function apart<L extends { at: number }>(labels: L[]): L[] {
  const sorted = [...labels].sort((a, b) => a.at - b.at);
  for (let k = 1; k < sorted.length; k++) sorted[k].at = Math.max(sorted[k].at, sorted[k - 1].at + 15);
  return sorted;
}
