// The half of all directions that light can come from: the normal in the middle, the sun to be dragged about.

import { useRef } from "preact/hooks";
import type { Point } from "../server/answers";
import { pointed } from "./pointed";

interface Props {
  elevation: number;
  azimuth: number;
  side: string;
  label: string;
  text: string;
  up: string;
  right: string;
  onSun: (elevation: number, azimuth: number) => void;
}

const RAD = Math.PI / 180;
const MOST = 89;

/** Where light comes from on the disc: right and up as seen from the room, the angle from the normal as distance. */
export function placeOf(elevation: number, azimuth: number): Point {
  const [e, a] = [elevation * RAD, azimuth * RAD];
  const [x, y, z] = [-Math.sin(a) * Math.cos(e), Math.sin(e), Math.cos(a) * Math.cos(e)];
  const sine = Math.hypot(x, y);
  const far = Math.atan2(sine, z) / RAD;
  return sine > 1e-9 ? [(x / sine) * far, (y / sine) * far] : [0, 0];
}

/** Elevation and azimuth of a place on the disc. */
export function sunOf([x, y]: Point): [number, number] {
  const far = Math.min(Math.hypot(x, y), MOST);
  const turn = Math.atan2(y, x);
  const sine = Math.sin(far * RAD);
  return [Math.asin(sine * Math.sin(turn)) / RAD, Math.atan2(-sine * Math.cos(turn), Math.cos(far * RAD)) / RAD];
}

export function DrawSky({ elevation, azimuth, side, label, text, up, right, onSun }: Props) {
  const drawing = useRef<SVGSVGElement>(null);
  const sun = placeOf(elevation, azimuth);
  const move = (event: PointerEvent) => {
    if (event.type === "pointermove" && !(event.buttons & 1)) return;
    const at = pointed(drawing.current, event);
    if (!at) return;
    const [e, a] = sunOf([at.x, -at.y]);
    onSun(half(e), half(a));
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
  };
  const key = (event: KeyboardEvent) => {
    const step = ({ ArrowUp: [1, 0], ArrowDown: [-1, 0], ArrowLeft: [0, 1], ArrowRight: [0, -1], PageUp: [10, 0], PageDown: [-10, 0], Home: [-elevation, -azimuth] } as Record<string, [number, number]>)[event.key];
    if (!step) return;
    event.preventDefault();
    onSun(clamp(elevation + step[0]), clamp(azimuth + step[1]));
  };
  const line = (points: Point[]) => `M${points.map(([x, y]) => `${x.toFixed(1)} ${(-y).toFixed(1)}`).join("L")}`;
  const steps = Array.from({ length: 37 }, (_, k) => -90 + 5 * k);
  return (
    <svg ref={drawing} class="drawing sky" viewBox="-106 -108 212 204" role="group" aria-label={label}>
      <circle class="skyGround" r={90} onPointerDown={move} onPointerMove={move} />
      <path class="skyHalf" d={side === "front" ? "M-90 0A90 90 0 0 1 90 0Z" : ""} />
      {[-60, -30, 0, 30, 60].map((deg) => (
        <g key={deg}>
          <path class="hair" d={line(steps.map((a) => placeOf(deg, a)))} />
          <path class="hair" d={line(steps.map((e) => placeOf(e, deg)))} />
        </g>
      ))}
      {[-60, -30, 30, 60].map((deg) => (
        <text key={deg} class="faint skyText" x={0} y={-placeOf(deg, 0)[1]} text-anchor="middle" dominant-baseline="central">
          {deg}°
        </text>
      ))}
      <circle class="skyRim" r={90} />
      <text class="faint skyText" y={-95} text-anchor="middle">
        {up}
      </text>
      <text class="faint skyText" x={97} transform="rotate(90 97 0)" text-anchor="middle">
        {right}
      </text>
      <g
        class="sun"
        role="slider"
        tabindex={0}
        aria-label={label}
        aria-valuemin={-MOST}
        aria-valuemax={MOST}
        aria-valuenow={Math.round(elevation)}
        aria-valuetext={text}
        onPointerDown={move}
        onPointerMove={move}
        onKeyDown={key}
      >
        <circle class="halo" cx={sun[0]} cy={-sun[1]} r={14} />
        <circle class="disc" cx={sun[0]} cy={-sun[1]} r={7} />
      </g>
    </svg>
  );
}

const clamp = (deg: number): number => Math.min(MOST, Math.max(-MOST, Math.round(10 * deg) / 10));
const half = (deg: number): number => clamp(Math.round(2 * deg) / 2);
