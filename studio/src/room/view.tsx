// The room: its picture in 3D with the light of the hour, its numbers, its plan and section.

import { useMemo, useRef, useState } from "preact/hooks";
import { unsure, written } from "../draw/written";
import { Faults } from "../parts/inputs";
import { saveFile } from "../parts/save";
import type { About } from "../server/answers";
import { useOnce } from "../server/follow";
import { change, type State } from "../state/state";
import { words } from "../words/page";
import { room as said } from "../words/room";
import type { RoomScene } from "./answers";
import { DARK, glassColour, isCut, LIGHT } from "./colours";
import { RoomControls } from "./controls";
import { ColourBar } from "./draw_plan";
import { type Eye, EYES, type EyeName, eyeOf, rounded } from "./eye";
import type { Field } from "./field";
import { RoomFigures } from "./figures";
import { RoomLegend } from "./legend";
import { RoomNumbers, RoomProgress } from "./numbers";
import { captioned } from "./picture";
import { Room3D } from "./picture_3d";
import { useRoom } from "./questions";
import { scaleOf } from "./scale";
import { ShowControls, SkyControls } from "./show";
import type { Met } from "./stage";
import type { RoomState } from "./state";
import { RoomTime } from "./time";
import { toldOf } from "./told";

const SPOT: Eye = { turn: 120, tilt: 24, far: 20, at: [2, 4, 1.5], isFlat: false };
const put = (values: Partial<RoomState>) => change("room", values);

export function RoomView({ state, isDark }: { state: State; isDark: boolean }) {
  const room = state.room;
  const asked = useRoom(room);
  const about = useOnce<About>("/api/about");
  const { scene, sun, paths, light, work, plane } = asked;
  const [aspect, setAspect] = useState(1.8);
  const picture = useRef<(() => HTMLCanvasElement) | null>(null);
  const look = isDark ? DARK : LIGHT;
  const unit = said.units[room.quantity] ?? "lx";

  const told = useMemo(() => toldOf(light.value, room.quantity), [light.value, room.quantity]);
  const scale = useMemo(() => told && scaleOf(told.values, room.isLog, room.low, room.high), [told, room.isLog, room.low, room.high]);
  const isStale = work.isStale || light.faults.length > 0;
  const isMatching = plane !== null && told !== null && light.value?.plane === plane.name && told.values.length === plane.points_m.length;
  const field: Field | null = isMatching && scale ? { plane, values: told.values, scale, isStale, picked: room.picked } : null;
  const eye = useMemo(() => eyeFrom(room, scene.value, aspect), [room.view, room.eye, scene.value, aspect]);
  // a sky without sun lets no sunlight in, wherever the sun stands
  const isHidden = light.value !== null && light.value.outside.direct_normal_lx === 0;
  const when = `${said.date(room.day)}, ${said.clock(room.minute)}`;
  const sunWords = sun.value ? (sun.value.is_up ? said.sunUp(sun.value.altitude_deg, sun.value.azimuth_deg) + (isHidden ? said.sunHidden : "") : said.sunDown) : "";
  const staged = {
    scene: scene.value,
    sun: sun.value,
    year: asked.year.value,
    light: sun.value?.is_up && !isHidden ? paths.value : null,
    field,
    shown: { direct: room.straight, redirected: room.redirected, reflected: room.reflected, beams: room.beams, patches: room.patches, sunPath: room.sunPath, field: room.field },
    eye,
    look,
    words: { compass: said.compass, hour: (hour: number) => `${hour} h` },
  };
  const numbers = told && plane ? said.numbersText(plane.name, written(told.mean), written(told.least), written(told.most), unit) : said.noNumbers;
  const title = scene.value?.name ?? said.room;
  const setView = (name: EyeName) => put({ view: name, eye: [] });
  const tell = (met: Met): string => {
    if (met?.kind === "window") return `${met.window.name}: ${met.window.glazing}`;
    if (met?.kind === "cell" && told) return sensorTold(met.cell);
    return "";
  };
  const sensorTold = (sensor: number): string => {
    if (!told || !plane?.points_m[sensor]) return "";
    const one = unsure(told.values[sensor], told.errors?.[sensor]);
    return `${one.error ? said.sensor(one.value, one.error, unit) : `${one.value} ${unit}`} (${plane.points_m[sensor].map((one) => one.toFixed(2)).join(", ")})`;
  };
  const png = () => {
    const made = picture.current?.();
    if (!made) return;
    const shown = (["direct", "redirected", "reflected"] as const).filter((kind) => room[kind === "direct" ? "straight" : kind]);
    const caption = {
      title,
      lines: [`${when} · ${sunWords}`, numbers],
      legend: shown.map((kind) => ({ kind, text: said.lines[kind] })),
      bar: field && room.field ? { scale: field.scale, unit, title: said.quantities[room.quantity] } : null,
    };
    captioned(made, caption, look).toBlob((blob) => blob && saveFile("room.png", blob));
  };
  const toml = about.value?.files.filter((file) => file.kind === "toml").map((file) => file.path) ?? [];
  const weathers = about.value?.files.filter((file) => file.kind === "weather" || file.path.endsWith(".epw")).map((file) => file.path) ?? [];
  const faults = [...scene.faults, ...sun.faults, ...paths.faults, ...light.faults].filter((fault, k, all) => !/key must be/.test(fault.message) && all.findIndex((one) => one.message === fault.message) === k);
  return (
    <div class="view roomView">
      <aside class="side" aria-label={said.room}>
        <RoomControls state={state} asked={asked} files={toml} isDark={isDark} faults={faults} />
        <SkyControls state={state} asked={asked} weathers={weathers} />
        <ShowControls state={state} asked={asked} />
      </aside>
      <div class="main">
        <section class="figure roomFigure" aria-label={said.picture}>
          <header>
            <div class="views" role="group" aria-label={said.viewsLabel}>
              {EYES.map((name) => (
                <button key={name} aria-pressed={room.view === name} onClick={() => setView(name)}>
                  {said.views[name]}
                </button>
              ))}
              <button aria-label={said.closer} title={said.closer} onClick={() => putEye({ ...eye, far: eye.far / 1.2 })}>
                +
              </button>
              <button aria-label={said.farther} title={said.farther} onClick={() => putEye({ ...eye, far: eye.far * 1.2 })}>
                −
              </button>
            </div>
            <span class="hint dragHint">{said.drag}</span>
            <div class="saves" role="group" aria-label={`${words.exports}: ${said.picture}`}>
              <button onClick={png}>PNG</button>
            </div>
          </header>
          <div class="stageHolder">
            <Room3D
              staged={staged}
              label={said.pictureText(title, when, sunWords, numbers)}
              help={said.pictureHelp}
              waiting={said.drawing}
              missing={said.noWebgl}
              told={tell}
              onAspect={setAspect}
              onEye={putEye}
              onHour={(hour) => put({ minute: Math.min(1435, Math.max(0, Math.round((60 * hour) / 5) * 5)) })}
              hour={room.minute / 60}
              sunLabel={said.dragSun}
              sunText={`${said.clock(room.minute)}, ${sunWords}`}
              onPick={(cell) => put({ picked: cell === room.picked ? -1 : cell })}
              onKey={(key) => /^[1-5]$/.test(key) && setView(EYES[Number(key) - 1])}
              onReady={(made) => (picture.current = made)}
            />
            <div class="stageTitle">
              <b>{title}</b>
              <span>
                {when} · {sunWords}
              </span>
            </div>
            {field && room.field && (
              <svg class="drawing bar" viewBox="-8 0 266 38" role="img" aria-label={said.quantities[room.quantity]}>
                <ColourBar scale={field.scale} unit={unit} wide={240} />
              </svg>
            )}
            <Compass turn={eye.turn} />
            <div class="windowParts" role="list" aria-label={said.windowParts}>
              {scene.value?.windows.map((window) => (
                <span key={window.name} role="listitem">
                  <i class={`swatch${isCut(window.kind) ? " cut" : ""}`} style={{ "--swatch": glassColour(window.kind, isDark) }} /> {window.name}: {window.glazing}
                </span>
              ))}
            </div>
          </div>
          <RoomTime day={room.day} minute={room.minute} sun={sun.value} />
          <RoomLegend room={room} isDark={isDark} onChange={put} />
        </section>
        <p class="unseen" role="status">
          {work.state === "done" && !isStale ? `${when}, ${sunWords}. ${numbers}` : ""}
        </p>
        <RoomNumbers told={told} unit={unit} light={light.value} isStale={isStale} />
        <RoomProgress work={work} sunWork={asked.sunWork} light={isStale ? null : light.value} target={room.error} known={faults} />
        {[...new Set([...(light.value?.notes ?? []), ...(paths.value?.warnings ?? [])])].map((note) => (
          <p key={note} class="hint note" role="note">
            {note}
          </p>
        ))}
        {sun.value?.is_up && (light.value?.outside.direct_normal_lx ?? 0) > 0 && <Faults faults={asked.sunWork.faults.filter((fault) => !/sunshine|key must/.test(fault.message))} />}
        {scene.value && plane && isMatching && scale && (
          <RoomFigures room={room} scene={scene.value} plane={plane} told={told} scale={scale} unit={unit} light={light.value} isStale={isStale} sensorTold={sensorTold} onChange={put} />
        )}
      </div>
    </div>
  );
}

/** Where north is in the picture: straight up when one looks north. */
function Compass({ turn }: { turn: number }) {
  return (
    <svg class="compass" viewBox="-24 -24 48 48" aria-hidden="true">
      <circle r={20} />
      <g transform={`rotate(${180 - turn})`}>
        <path d="M0 -15L5 4H-5Z" class="north" />
        <path d="M0 15L5 4H-5Z" />
        <text y={-16.5} text-anchor="middle">
          {said.compass[0]}
        </text>
      </g>
    </svg>
  );
}

const putEye = (to: Eye) => {
  const { turn, tilt, far, at, isFlat } = rounded(to);
  put({ view: "", eye: [turn, tilt, far, ...at, Number(isFlat)] });
};

/** The eye of the state: one of those ready-made for this room, or one's own. */
function eyeFrom(room: RoomState, scene: RoomScene | null, aspect: number): Eye {
  const own = room.eye;
  if (!room.view && own.length === 7 && own.every((one) => Number.isFinite(one))) return rounded({ turn: own[0], tilt: own[1], far: own[2], at: [own[3], own[4], own[5]], isFlat: own[6] === 1 });
  const name = EYES.find((one) => one === room.view) ?? "overview";
  return scene ? eyeOf(name, scene, aspect) : SPOT;
}
