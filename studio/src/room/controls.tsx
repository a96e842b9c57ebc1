// The controls of a room: which one, its sizes, the glazing of its window parts, its place.

import type { ComponentChildren } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { chosen, ChoiceInput, Faults, SliderInput } from "../parts/inputs";
import { saveFile } from "../parts/save";
import { ask, type Fault, Refused } from "../server/ask";
import { change, type State } from "../state/state";
import { words } from "../words/page";
import { room as said } from "../words/room";
import type { RoomKinds, RoomSlider, Tables } from "./answers";
import { glassColour } from "./colours";
import type { Asked } from "./questions";
import { changes, glazingOf, glazingPlaces, panelTable, placed, valueAt, withGlazing, withValue } from "./tables";

interface Props {
  state: State;
  asked: Asked;
  files: string[];
  isDark: boolean;
  faults: Fault[];
}

export function RoomControls({ state, asked, files, isDark, faults: all }: Props) {
  const { kinds, file, tables, scene } = asked;
  const room = state.room;
  const [fileFaults, setFileFaults] = useState<Fault[]>([]);
  const put = (to: Tables) => file && change("room", { tables: changes(file, to) });
  const open = async (given: File | undefined) => {
    if (!given) return;
    try {
      const read = await ask<{ tables: Tables }>("/api/room/read", { text: await given.text() });
      setFileFaults([]);
      change("room", { file: "", tables: read.tables, variant: "", plane: "", picked: -1, view: room.view || "overview" });
    } catch (fault) {
      setFileFaults([{ field: null, message: `${words.badFile}: ${(fault as Refused).message}` }]);
    }
  };
  const save = async () => asked.room && saveFile("room.toml", (await ask<{ text: string }>("/api/room/toml", { room: asked.room })).text);
  const isChanged = room.file !== "" && Object.keys(room.tables).length > 0;
  const names: [string, string][] = [["start", said.start], ...files.map((path): [string, string] => [path, path]), ...(room.file === "" ? [["", said.own] as [string, string]] : [])];
  const variants = scene.value?.variants ?? [];
  const sliders = (kinds.value?.sliders ?? []).filter((slider) => tables && typeof valueAt(tables, slider.path) === "number");
  const faults = all.map((fault) => placed(fault, sliders));
  const of = (group: string, names?: string[]) => sliders.filter((slider) => slider.group === group && (!names || names.includes(slider.name)));
  const sizes = (list: RoomSlider[]) =>
    list.map((slider) => {
      const value = valueAt(tables, slider.path) as number;
      return (
        <SliderInput
          key={slider.path.join(".")}
          id={`room-${slider.path.join("-")}`}
          field={slider.path.map(String).join(".")}
          label={labelOf(slider)}
          value={value}
          low={Math.min(slider.low, value)}
          high={Math.max(slider.high, value)}
          step={slider.step}
          unit={slider.unit}
          faults={faults}
          onChange={(to) => tables && put(withValue(tables, slider.path, to))}
        />
      );
    });
  const isWrong = (list: RoomSlider[]) => list.some((slider) => faults.some((fault) => fault.field === slider.path.join(".")));
  const surfaces = ["floor", "walls", "ceiling"];
  return (
    <>
      <fieldset class="controls">
        <legend>{said.room}</legend>
        <ChoiceInput id="room-file" label={said.choose} value={room.file} options={names.map(([value, label]) => [value, value === room.file && isChanged ? said.changed(label) : label])} onChange={(path) => change("room", { file: path, tables: {}, variant: "", plane: "", picked: -1 })} />
        {variants.length > 1 && <ChoiceInput id="room-variant" label={said.variant} value={room.variant || variants[0]} options={variants.map((name): [string, string] => [name, name])} onChange={(name) => change("room", { variant: name === variants[0] ? "" : name })} />}
        <div class="files">
          <label class="button">
            {words.openToml}
            <input type="file" accept=".toml" onChange={(event) => void open(chosen(event))} />
          </label>
          <button onClick={() => void save()}>{said.save}</button>
          {isChanged && <button onClick={() => change("room", { tables: {} })}>{said.reset}</button>}
        </div>
        <Faults faults={[...fileFaults, ...kinds.faults, ...faults]} fields={sliders.map((slider) => slider.path.join("."))} />
      </fieldset>
      {tables && kinds.value && (
        <>
          <Group title={said.glazings} isOpen>
            {[...glazingPlaces(tables).keys()].map((window) => (
              <GlazingChoice key={window} window={window} kinds={kinds.value as RoomKinds} tables={tables} state={state} isDark={isDark} kind={scene.value?.windows.find((one) => one.name === window)?.kind ?? ""} put={put} />
            ))}
          </Group>
          {of("room").length > 0 ? (
            <Group title={said.groups.room} isOpen>
              {sizes(of("room").filter((slider) => !surfaces.includes(slider.name)))}
            </Group>
          ) : (
            <p class="hint">{said.noShoebox}</p>
          )}
          {of("window").length > 0 && <Group title={said.groups.window} isOpen={isWrong([...of("window"), ...of("upper part")])}>{sizes([...of("window"), ...of("upper part")])}</Group>}
          {of("room", surfaces).length > 0 && <Group title={said.groups.reflectances} isOpen={isWrong(of("room", surfaces))}>{sizes(of("room", surfaces))}</Group>}
          {of("sensors").length > 0 && <Group title={said.groups.sensors} isOpen={isWrong(of("sensors"))}>{sizes(of("sensors"))}</Group>}
          <Group title={said.groups.site}>
            {!asked.hasSite && <p class="hint">{said.noSite}</p>}
            {sizes(of("site"))}
            {typeof valueAt(tables, ["site", "timezone"]) === "string" && (
              <div class="input">
                <label for="room-timezone">{said.timezone}</label>
                <input id="room-timezone" type="text" value={String(valueAt(tables, ["site", "timezone"]))} onChange={(event) => put(withValue(tables, ["site", "timezone"], event.currentTarget.value))} />
              </div>
            )}
          </Group>
        </>
      )}
    </>
  );
}

export function Group({ title, isOpen = false, children }: { title: string; isOpen?: boolean; children: ComponentChildren }) {
  const place = useRef<HTMLDetailsElement>(null);
  useEffect(() => {
    if (isOpen && place.current) place.current.open = true;
  }, [isOpen]);
  return (
    <details class="group" ref={place}>
      <summary>{title}</summary>
      {children}
    </details>
  );
}

function GlazingChoice({ window, kinds, tables, state, kind, isDark, put }: { window: string; kinds: RoomKinds; tables: Tables; state: State; kind: string; isDark: boolean; put: (tables: Tables) => void }) {
  const now = glazingOf(tables, state.room.variant, window) ?? "";
  const own = Object.keys((tables.glazings as Tables | undefined) ?? {});
  const labels = new Map(kinds.glazings.map((one) => [one.name, one.label]));
  const panels: Record<string, Tables> = { "panel A": panelTable(state.panel.a), "panel B": panelTable(state.panel.b) };
  const behind = (name: string) => `${name} behind glass`;
  const options: [string, string][] = [
    ...kinds.glazings.map((one): [string, string] => [one.name, one.label]),
    ...own.filter((name) => !labels.has(name) && !name.startsWith("panel A") && !name.startsWith("panel B")).map((name): [string, string] => [name, name]),
    ...Object.keys(panels).flatMap((name): [string, string][] => [
      [name, said.fromPanel(name.slice(-1))],
      [behind(name), said.fromPanelBehind(name.slice(-1))],
    ]),
  ];
  if (!options.some(([name]) => name === now)) options.unshift([now, now]);
  const choose = (name: string) => {
    const ready = Object.fromEntries(kinds.glazings.filter((one) => !own.includes(one.name)).map((one) => [one.name, one.table]));
    const panel = Object.keys(panels).find((one) => name === one || name === behind(one));
    const added = panel ? { ...ready, [panel]: panels[panel], ...(name === panel ? {} : { [name]: { kind: "stack", layers: ["glass", panel] } }) } : ready;
    put(withGlazing(tables, state.room.variant, window, name, added));
  };
  const id = `glazing-${window.replace(/\W/g, "-")}`;
  return (
    <div class="input glazing">
      <label for={id}>
        <i class="swatch" style={{ background: glassColour(kind, isDark) }} /> {window}
      </label>
      <select id={id} aria-label={said.glazingOf(window)} value={now} onChange={(event) => choose(event.currentTarget.value)}>
        {options.map(([name, label]) => (
          <option key={name} value={name}>
            {label}
          </option>
        ))}
      </select>
    </div>
  );
}

function labelOf(slider: RoomSlider): string {
  if (slider.group === "upper part") return said.partHeight;
  if (slider.group === "sensors" && slider.name === "height_m") return said.planeHeight;
  return said.fields[slider.name] ?? slider.name;
}
