// The ground with its compass, the paths of the sun over the site, and the sun.

import { CircleGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, SphereGeometry } from "three";
import type { SunHour, SunTold, SunYear, Vec } from "./answers";
import type { Look } from "./colours";
import type { Dome } from "./eye";
import { joined, label, segments } from "./lines";
import { long, minus, plus } from "./space";

const NAMED_DEG = 38;

export interface DomeWords {
  compass: [string, string, string, string];
  hour: (hour: number) => string;
}

export function drawGround(dome: Dome, look: Look, words: DomeWords): Group {
  const group = new Group();
  const [cx, cy, cz] = dome.centre;
  const disc = new Mesh(new CircleGeometry(1.06 * dome.radius, 96), new MeshBasicMaterial({ color: look.disc, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 6, polygonOffsetUnits: 6 }));
  disc.position.set(cx, cy, cz - 0.02);
  disc.renderOrder = -2;
  group.add(disc);
  const at = (deg: number, share: number): Vec => {
    const turn = (deg * Math.PI) / 180;
    return [cx + Math.sin(turn) * dome.radius * share, cy + Math.cos(turn) * dome.radius * share, cz];
  };
  const ring = Array.from({ length: 121 }, (_, k) => at(3 * k, 1));
  group.add(segments(joined(ring), { colour: look.hair, width: 1.2 }));
  const ticks = Array.from({ length: 36 }, (_, k): [Vec, Vec] => [at(10 * k, k % 9 ? 0.985 : 0.955), at(10 * k, 1)]);
  group.add(segments(ticks, { colour: look.hair, width: 1.2 }));
  words.compass.forEach((letter, k) => group.add(label(letter, at(90 * k, 1.09), k ? look.faint : look.ink, look.halo, 15, k ? 500 : 700)));
  return group;
}

/** Paths of the day, of the solstices and equinoxes, and of each hour through the year, above the horizon. */
export function drawSunPaths(sun: SunTold, year: SunYear, dome: Dome, look: Look, words: DomeWords): Group {
  const group = new Group();
  const on = (direction: Vec): Vec => plus(dome.centre, direction, dome.radius);
  const isUp = (pair: { altitude_deg: number }[]) => pair.every((one) => one.altitude_deg > -0.9);
  // where the clock is changed a loop of an hour is open
  const isNear = (a: { direction: Vec }, b: { direction: Vec }) => long(minus(a.direction, b.direction)) < 0.12;
  const arc = (places: { altitude_deg: number; direction: Vec }[]): [Vec, Vec][] =>
    places.slice(1).flatMap((to, k): [Vec, Vec][] => (isUp([places[k], to]) && isNear(places[k], to) ? [[on(places[k].direction), on(to.direction)]] : []));
  const put = (pairs: [Vec, Vec][], width: number, colour: string, opacity: number) => pairs.length && group.add(segments(pairs, { colour, width, opacity }));
  put(year.analemmas.flatMap((one) => arc(one.points)), 1, look.hair, 0.45);
  const others = year.seasons.filter((one) => !isSame(one.points, sun.day));
  put(others.flatMap((one) => arc(one.points)), 1.2, look.faint, 0.6);
  for (const season of others) {
    const there = named(season.points);
    if (there) group.add(label(season.label, plus(dome.centre, there.direction, 1.05 * dome.radius), look.faint, look.halo, 12, 500));
  }
  put(arc(sun.day), 3.2, look.sun, 1);
  for (const hour of sun.day) {
    if (hour.altitude_deg < 0 || Math.abs(hour.hour - Math.round(hour.hour)) > 1e-6) continue;
    const dot = new Mesh(new SphereGeometry(0.011 * dome.radius, 10, 8), new MeshBasicMaterial({ color: look.sun }));
    dot.position.set(...on(hour.direction));
    group.add(dot);
    if (hour.hour % 3 === 0) group.add(label(words.hour(hour.hour), plus(dome.centre, hour.direction, 1.07 * dome.radius), look.ink, look.halo, 12, 500));
  }
  return group;
}

/** The sun, and the line to what it shines at, if it does. */
export function drawSun(sun: SunTold, dome: Dome, look: Look, aim: Vec | null): Group {
  const group = new Group();
  const at = plus(dome.centre, sun.direction, dome.radius);
  const dim = sun.is_up ? 1 : 0.3;
  const ball = new Mesh(new SphereGeometry(0.042 * dome.radius, 24, 16), new MeshBasicMaterial({ color: look.sun, transparent: dim < 1, opacity: dim }));
  ball.position.set(...at);
  const halo = new Mesh(new SphereGeometry(0.075 * dome.radius, 24, 16), new MeshBasicMaterial({ color: look.sun, transparent: true, opacity: 0.25 * dim, depthWrite: false }));
  halo.position.copy(ball.position);
  group.add(ball, halo);
  if (sun.is_up) {
    if (aim) group.add(segments([[at, aim]], { colour: look.sun, width: 1.4, opacity: 0.8, dash: [0.02 * dome.radius, 0.015 * dome.radius] }));
    const foot: Vec = [at[0], at[1], dome.centre[2]];
    group.add(segments([[at, foot], [foot, dome.centre]], { colour: look.faint, width: 1, opacity: 0.45, dash: [0.012 * dome.radius, 0.012 * dome.radius] }));
  }
  return group;
}

/** Whether two days' paths would be drawn upon one another. */
const isSame = (a: SunHour[], b: SunHour[]) => a.every((one, k) => Math.abs(one.altitude_deg - (b[k]?.altitude_deg ?? 0)) < 0.4);

/** Where an arc has its name: in the afternoon at a height where arcs are apart, or as high as it gets. */
function named(points: SunHour[]): SunHour | undefined {
  const up = points.filter((one) => one.altitude_deg > 3);
  const after = up.slice(up.findIndex((one) => one.altitude_deg === Math.max(...up.map((other) => other.altitude_deg))));
  return after.sort((a, b) => Math.abs(a.altitude_deg - NAMED_DEG) - Math.abs(b.altitude_deg - NAMED_DEG))[0];
}
