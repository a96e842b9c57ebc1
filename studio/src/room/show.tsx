// The sky over the room, and what of the room is shown.

import { ChoiceInput, SliderInput } from "../parts/inputs";
import { change, type State } from "../state/state";
import { room as said } from "../words/room";
import { Group } from "./controls";
import type { Asked } from "./questions";

export function SkyControls({ state, asked, weathers }: { state: State; asked: Asked; weathers: string[] }) {
  const room = state.room;
  const skies = asked.kinds.value?.skies ?? [];
  const sky = skies.find((one) => one.name === room.sky);
  const options = [...skies.map((one): [string, string] => [one.name, one.label]), ...weathers.map((path): [string, string] => [path, said.weather(path)])];
  if (!options.some(([name]) => name === room.sky)) options.push([room.sky, room.sky]);
  return (
    <Group title={said.sky} isOpen>
      <ChoiceInput id="room-sky" label={said.sky} value={room.sky} options={options} onChange={(name) => change("room", { sky: name })} />
      {sky && "luminous_turbidity" in sky.sky && <SliderInput id="room-turbidity" field="luminous_turbidity" label={said.turbidity} value={room.turbidity} low={2} high={10} step={0.1} unit="" faults={asked.light.faults} onChange={(turbidity) => change("room", { turbidity })} />}
    </Group>
  );
}

export function ShowControls({ state, asked }: { state: State; asked: Asked }) {
  const room = state.room;
  const names = asked.scene.value?.plane_names ?? [];
  return (
    <Group title={said.show} isOpen>
      {names.length > 0 && <ChoiceInput id="room-plane" label={said.plane} value={asked.plane?.name ?? names[0]} options={names.map((name): [string, string] => [name, name])} onChange={(plane) => change("room", { plane: plane === names[0] ? "" : plane, picked: -1 })} />}
      <ChoiceInput id="room-quantity" label={said.quantity} value={room.quantity} options={Object.entries(said.quantities)} onChange={(quantity) => change("room", { quantity, low: 0, high: 0 })} />
      <label class="check">
        <input type="checkbox" checked={room.isLog} onChange={(event) => change("room", { isLog: event.currentTarget.checked })} /> {said.log}
      </label>
      <label class="check">
        <input type="checkbox" checked={room.high > 0} onChange={(event) => change("room", event.currentTarget.checked ? (room.quantity === "factor" ? { low: 0.1, high: 10 } : { low: 20, high: 5000 }) : { low: 0, high: 0 })} /> {said.fixed}
      </label>
      {room.high > 0 && (
        <div class="range">
          {(["low", "high"] as const).map((end) => (
            <label key={end}>
              {end === "low" ? said.from : said.to}
              <input type="number" min={0} value={room[end]} onChange={(event) => event.currentTarget.valueAsNumber > 0 && change("room", { [end]: event.currentTarget.valueAsNumber })} />
              {said.units[room.quantity]}
            </label>
          ))}
        </div>
      )}
      <SliderInput id="room-error" field="target_relative_error" label={said.target} value={Math.round(1000 * room.error) / 10} low={0.5} high={20} step={0.5} unit="%" faults={asked.work.faults} onChange={(error) => change("room", { error: Math.round(10 * error) / 1000 })} />
    </Group>
  );
}
