// The plan, the section and the table of a plane's values.

import { useMemo } from "preact/hooks";
import { unsure, written } from "../draw/written";
import { Heads } from "../parts/data_table";
import { Figure } from "../parts/save";
import { room as said } from "../words/room";
import type { Plane, RoomLight, RoomScene } from "./answers";
import { DrawPlan } from "./draw_plan";
import { DrawDepth } from "./draw_section";
import { along, flatten } from "./flat";
import type { Told } from "./numbers";
import { type Scale, scaleOf } from "./scale";
import type { RoomState } from "./state";

interface Props {
  room: RoomState;
  scene: RoomScene;
  plane: Plane;
  told: Told;
  scale: Scale;
  unit: string;
  light: RoomLight | null;
  isStale: boolean;
  sensorTold: (sensor: number) => string;
  onChange: (values: Partial<RoomState>) => void;
}

export function RoomFigures({ room, scene, plane, told, scale, unit, light, isStale, sensorTold, onChange }: Props) {
  const flat = useMemo(() => flatten(plane, scene), [plane, scene]);
  const line = useMemo(() => along(flat, told.values, room.picked), [flat, told, room.picked]);
  const seen = line.band.flatMap((one) => [one.least, one.most]);
  const upright = room.high > 0 ? scale : scaleOf(seen, room.isLog);
  const column = (k: 0 | 1 | 2) => plane.points_m.map((one) => one[k]);
  const errors = told.errors ?? [];
  const table = (sensors: number[]) => ({
    x_m: sensors.map((k) => column(0)[k]),
    y_m: sensors.map((k) => column(1)[k]),
    z_m: sensors.map((k) => column(2)[k]),
    [`${room.quantity}_${unit === "%" ? "percent" : unit}`]: sensors.map((k) => told.values[k]),
    ...(errors.length ? { [`standard_error_${unit === "%" ? "percent" : unit}`]: sensors.map((k) => errors[k]) } : {}),
    ...(light && room.quantity === "total" ? Object.fromEntries(Object.entries(light.parts).map(([name, values]) => [`${name}_lx`, sensors.map((k) => values[k])])) : {}),
  });
  const all = plane.points_m.map((_, k) => k);
  const pick = (sensor: number) => onChange({ picked: sensor === room.picked ? -1 : sensor });
  const at = line.sensors.length ? `y = ${flat.points[line.sensors[0]][1].toFixed(2)} m` : "";
  const text = said.numbersText(plane.name, written(told.mean), written(told.least), written(told.most), unit);
  return (
    <>
      <div class="grid">
        <Figure name="room-plan" title={`${said.planTitle}: ${plane.name}`} hint={said.planHint} table={() => table(all)}>
          <div class="views small" role="group" aria-label={said.planTitle}>
            {(["lines", "values"] as const).map((name) => (
              <button key={name} aria-pressed={room.plan === name} onClick={() => onChange({ plan: name })}>
                {name === "lines" ? said.isolux : said.values}
              </button>
            ))}
          </div>
          <DrawPlan plane={plane} flat={flat} values={told.values} scale={scale} unit={unit} picked={room.picked} isStale={isStale} hasValues={room.plan === "values"} label={`${said.planTitle}. ${text}`} told={sensorTold} onPick={(sensor) => onChange({ picked: sensor })} />
        </Figure>
        <Figure name="room-section" title={flat.isDepth ? said.sectionTitle : said.alongTitle} hint={said.sectionHint(at)} table={() => ({ distance_m: line.sensors.map((k) => flat.points[k][0]), ...table(line.sensors) })}>
          <DrawDepth line={line} distances={flat.points.map((one) => one[0])} values={told.values} errors={told.errors} scale={upright} unit={unit} picked={room.picked} isStale={isStale} axis={flat.isDepth ? said.depth : said.distance} label={`${said.sectionTitle}. ${text}`} onPick={pick} />
        </Figure>
      </div>
      <details class="group">
        <summary>{said.tableTitle}</summary>
        <div class="scrolls" tabIndex={0} role="region" aria-label={said.tableTitle}>
          <table>
            <Heads words={said.tableHeads} />
            <tbody>
              {all.map((k) => (
                <tr key={k}>
                  {plane.points_m[k].map((one, axis) => (
                    <td key={axis}>{one.toFixed(2)}</td>
                  ))}
                  <td>
                    {unsure(told.values[k], errors[k]).value} {unit}
                  </td>
                  <td>{unsure(told.values[k], errors[k]).error || "–"}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      </details>
    </>
  );
}
