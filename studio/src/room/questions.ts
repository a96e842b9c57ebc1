// What the room view asks of the server: the room, its sun, its light, the work that refines it.

import { useEffect, useMemo, useState } from "preact/hooks";
import { type Answer, type Doing, useAnswer, useJob, useOnce } from "../server/follow";
import type { LightPaths, Plane, RoomKinds, RoomLight, RoomScene, RoomWork, SunTold, SunYear, Tables } from "./answers";
import type { RoomState } from "./state";

/** Places of each window from which paths are drawn. */
const PATHS = 8;

export interface Asked {
  kinds: Answer<RoomKinds>;
  /** The tables of the file alone, and with what was changed. */
  file: Tables | null;
  tables: Tables | null;
  /** As a request says it. */
  room: { tables: Tables } | { path: string } | null;
  hasSite: boolean;
  scene: Answer<RoomScene>;
  sun: Answer<SunTold>;
  year: Answer<SunYear>;
  paths: Answer<LightPaths>;
  work: Doing<RoomWork>;
  sunWork: Doing<RoomWork>;
  light: Answer<RoomLight>;
  plane: Plane | null;
}

export function useRoom(state: RoomState): Asked {
  const kinds = useOnce<RoomKinds>("/api/room/kinds");
  const isPath = state.file !== "start" && state.file !== "";
  const read = useAnswer<RoomScene>("/api/room/scene", isPath ? { room: { path: state.file } } : null);
  const file = isPath ? (read.value?.tables ?? null) : state.file === "start" ? (kinds.value?.start ?? null) : {};
  const start = kinds.value?.start;
  const { tables, room, hasSite } = useMemo(() => {
    if (!file || !start) return { tables: null, room: null, hasSite: true };
    const told: Tables = { ...file, ...state.tables };
    const hasSite = Boolean(told.site ?? told.weather);
    const tables = hasSite ? told : { ...told, site: start.site };
    return { tables, room: isPath && hasSite && !Object.keys(state.tables).length ? { path: state.file } : { tables }, hasSite };
  }, [file, start, state.tables, state.file]);

  const variant = state.variant || undefined;
  const hour = state.minute / 60;
  const scene = useAnswer<RoomScene>("/api/room/scene", room && { room, variant });
  const site = scene.value?.site ?? null;
  const when = { day_of_year: state.day, hour };
  const sun = useAnswer<SunTold>("/api/room/sun", site && { site, ...when });
  // the ways through the year are those of the site, whatever the day
  const year = useAnswer<SunYear>("/api/room/sun", site && { site, day_of_year: 172, hour: 12, year: true });
  const paths = useAnswer<LightPaths>("/api/room/paths", room && site && { room, variant, ...when, density: PATHS });
  const names = scene.value?.plane_names ?? [];
  const plane = names.includes(state.plane) ? state.plane : (names[0] ?? "");
  const laid = useAnswer<RoomScene>("/api/room/scene", room && plane && plane !== names[0] ? { room, variant, planes: [plane] } : null);
  const planes = [...(scene.value?.planes ?? []), ...(laid.value?.planes ?? [])];
  const work = useJob<RoomWork>({ kind: "room", room, variant, surface: plane, target_relative_error: state.error }, Boolean(room && plane));
  const skies = kinds.value?.skies;
  const told = skies?.find((one) => one.name === state.sky) ;
  const sky = told ? ("luminous_turbidity" in told.sky ? { ...told.sky, luminous_turbidity: state.turbidity } : told.sky) : { kind: "weather", path: state.sky };
  const question = work.value?.key && skies ? { key: work.value.key, ...when, sky } : null;
  const [hasSun, setHasSun] = useState(false);
  // the sun's light is refined once the time has stood still
  const sunWork = useJob<RoomWork>({ kind: "room_sun", ...question, target_relative_error: state.error }, Boolean(question && sun.value?.is_up && hasSun));
  const light = useAnswer<RoomLight>("/api/room/light", question, `${work.value?.rounds} ${sunWork.isStale ? "" : sunWork.value?.rounds}`);
  useEffect(() => setHasSun((light.value?.outside.direct_normal_lx ?? 0) > 0), [light.value]);
  // a studio that was started again has nothing kept: the work begins once more
  const isLost = light.faults.some((fault) => /key must be/.test(fault.message));
  useEffect(() => {
    if (isLost && (work.state === "done" || work.state === "failed")) work.start();
  }, [isLost]);
  return { kinds, file, tables, room, hasSite, scene: isPath && !room ? read : scene, sun, year, paths, work, sunWork, light, plane: planes.find((one) => one.name === plane) ?? null };
}
