// The legend of the room's picture, each entry a switch.

import { room as said } from "../words/room";
import { OF_PATH } from "./colours";
import type { RoomState } from "./state";

type Switch = "straight" | "redirected" | "reflected" | "beams" | "patches" | "sunPath" | "field";
const SWITCHES: Switch[] = ["straight", "redirected", "reflected", "beams", "patches", "sunPath", "field"];

export function RoomLegend({ room, isDark, onChange }: { room: RoomState; isDark: boolean; onChange: (values: Partial<RoomState>) => void }) {
  return (
    <div class="roomLegend" role="group" aria-label={said.legend}>
      {SWITCHES.map((name) => (
        <button key={name} class="chip" aria-pressed={room[name]} title={said.toggles[name]} onClick={() => onChange({ [name]: !room[name] })}>
          <Swatch name={name} isDark={isDark} /> {said.short[name]}
        </button>
      ))}
    </div>
  );
}

function Swatch({ name, isDark }: { name: Switch; isDark: boolean }) {
  const dark = isDark ? 1 : 0;
  const line = (colour: string, dash?: string) => <path d="M1 7h20" stroke={colour} stroke-width={3} stroke-dasharray={dash} fill="none" />;
  return (
    <svg class="chipMark" viewBox="0 0 22 14" aria-hidden="true">
      {name === "straight" && line(OF_PATH.direct[dark])}
      {name === "redirected" && line(OF_PATH.redirected[dark])}
      {name === "reflected" && line(OF_PATH.reflected[dark], "4 3")}
      {name === "beams" && <path d="M1 1h6l14 12H9Z" fill={OF_PATH.direct[dark]} fill-opacity={0.45} />}
      {name === "patches" && <path d="M5 3h16l-4 9H1Z" fill={OF_PATH.direct[dark]} fill-opacity={0.7} stroke={OF_PATH.direct[dark]} />}
      {name === "sunPath" && (
        <>
          <path d="M1 13Q11 -8 21 13" fill="none" stroke="var(--sun)" stroke-width={2} />
          <circle cx={15} cy={5} r={3} fill="var(--sun)" />
        </>
      )}
      {name === "field" && ["#00224e", "#575d6d", "#a59c74", "#fee838"].map((colour, k) => <rect key={k} x={1 + 5 * k} y={2} width={5} height={10} fill={colour} />)}
    </svg>
  );
}
