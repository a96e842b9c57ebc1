// The light in the room: paths from outside to ceiling and on, shafts of sunlight, sunlit patches.

import { AdditiveBlending, Group, type MeshBasicMaterial, NormalBlending } from "three";
import type { LightBeam, LightPaths, Patch, PathKind, RoomWindow, Vec } from "./answers";
import { type Look, pathColour } from "./colours";
import { fan, faces, joined, segments } from "./lines";
import { dot, minus } from "./space";

export type LightShown = Record<PathKind, boolean> & { beams: boolean; patches: boolean };

/** Pieces of equal kind and about equal power are drawn as one: opacity and width tell power, by factors of four. */
const BINS = [0.25, 0.0625, 0.0156, 0.0039, 0];
const WIDTHS = [2.6, 2, 1.5, 1.2, 1];
const OPACITIES = [0.9, 0.7, 0.5, 0.36, 0.24];
/** Light that goes back outside is told more quietly. */
const OUTSIDE = 0.35;
/** Light on its way to the windows is drawn as this share of the strongest. */
const COMING = 0.2;

export function drawLight(light: LightPaths, windows: RoomWindow[], shown: LightShown, look: Look): Group {
  const group = new Group();
  const pieces = piecesOf(light, windows).filter((one) => shown[one.kind]);
  for (const kind of ["reflected", "direct", "redirected"] as const)
    for (const isOut of [true, false])
      BINS.forEach((least, bin) => {
        const own = pieces.filter((one) => one.kind === kind && one.isOut === isOut && one.power >= least && (bin === 0 || one.power < BINS[bin - 1]));
        if (!own.length) return;
        const opacity = OPACITIES[bin] * (isOut ? OUTSIDE : 1);
        const lines = segments(own.map((one) => one.ends), { colour: pathColour(kind, look.isDark), width: WIDTHS[bin], opacity, dash: kind === "reflected" ? [0.1, 0.07] : undefined });
        lines.renderOrder = 4;
        group.add(lines);
      });
  if (shown.patches) drawPatches(light, look, shown).forEach((one) => group.add(one));
  const strongest = Math.max(...light.patches.map((one) => one.illuminance_per_normal), 1e-9);
  if (shown.beams) light.beams.forEach((beam, k) => isShown(beam, shown) && group.add(drawShaft(light.patches.filter((one) => one.beam === k), beam, strongest, look)));
  return group;
}

interface Piece {
  ends: [Vec, Vec];
  kind: PathKind;
  power: number;
  isOut: boolean;
}

/** What each piece of a path is, and how strong; what paths have in common is there once. */
function piecesOf(light: LightPaths, windows: RoomWindow[]): Piece[] {
  const found = new Map<string, Piece>();
  for (const path of light.paths) {
    const window = windows.find((one) => one.name === path.window);
    let bounces = 0;
    let met = 0;
    path.points.slice(1).forEach((to, k) => {
      const from = path.points[k];
      if (path.stages[k] === "diffuse") bounces++;
      if (path.stages[k] === "glazing") met++;
      const kind: PathKind = bounces ? "reflected" : met && path.kind === "redirected" ? "redirected" : "direct";
      const power = met ? (path.segment_power[k] ?? path.power) : COMING;
      const isOut = met > 0 && window !== undefined && dot(minus(to, window.outline_m[0]), window.normal) < -0.05;
      const key = [...from, ...to].map((one) => one.toFixed(3)).join(" ") + kind;
      const old = found.get(key);
      found.set(key, { ends: [from, to], kind, power: Math.max(power, old?.power ?? 0), isOut });
    });
  }
  return [...found.values()];
}

const isShown = (beam: LightBeam, shown: LightShown) => (beam.total_reflections > 0 ? shown.redirected : shown.direct);
const beamColour = (beam: LightBeam | undefined, look: Look) => pathColour(beam && beam.total_reflections > 0 ? "redirected" : "direct", look.isDark);

/** How strongly a share of the strongest light is drawn: weak light is to be seen, and to be seen as weak. */
const told = (share: number) => Math.min(1, Math.max(share, 0)) ** 0.6;

/** The sides of a beam from its window to where it lands, as strong as the light in it. */
function drawShaft(patches: Patch[], beam: LightBeam, strongest: number, look: Look): Group {
  const group = new Group();
  if (!patches.length) return group;
  const colour = beamColour(beam, look);
  const strength = told(Math.max(...patches.map((one) => one.illuminance_per_normal)) / strongest);
  const sides = patches.flatMap(({ polygon, source }) => polygon.map((_, k): Vec[] => [source[k], source[(k + 1) % source.length], polygon[(k + 1) % polygon.length], polygon[k]]));
  const outer = alone(sides, (side) => [side[3], side[2]]);
  const mesh = faces(outer.flatMap(fan), colour, { opacity: (look.isDark ? 0.1 : 0.15) * strength, isDouble: true });
  (mesh.material as MeshBasicMaterial).blending = look.isDark ? AdditiveBlending : NormalBlending;
  mesh.renderOrder = 3;
  const edges = segments(outer.map((side): [Vec, Vec] => [side[0], side[3]]), { colour, width: 1, opacity: 0.45 * strength });
  edges.renderOrder = 3;
  group.add(mesh, edges);
  return group;
}

function drawPatches(light: LightPaths, look: Look, shown: LightShown): Group[] {
  const most = Math.max(...light.patches.map((one) => one.illuminance_per_normal), 1e-9);
  return light.beams.map((beam, k) => {
    const group = new Group();
    const own = light.patches.filter((one) => one.beam === k);
    if (!own.length || !isShown(beam, shown)) return group;
    const colour = beamColour(beam, look);
    for (const patch of own) {
      const mesh = faces(fan(patch.polygon), colour, { opacity: 0.05 + 0.65 * told(patch.illuminance_per_normal / most), isDouble: true, lifts: -2 });
      mesh.renderOrder = 1;
      group.add(mesh);
    }
    const rim = alone(own.flatMap((one) => joined(one.polygon, true)), (ends) => ends);
    const edges = segments(rim, { colour, width: 1.4, opacity: 0.1 + 0.8 * told(own[0].illuminance_per_normal / most) });
    edges.renderOrder = 1;
    group.add(edges);
    return group;
  });
}

/** Those whose edge no other shares: pieces that meet are one. */
function alone<T>(all: T[], edge: (one: T) => [Vec, Vec]): T[] {
  const key = (one: T) => edge(one).map((at) => at.map((x) => Math.round(500 * x)).join(" ")).sort().join(",");
  const times = new Map<string, number>();
  for (const one of all) times.set(key(one), (times.get(key(one)) ?? 0) + 1);
  return all.filter((one) => times.get(key(one)) === 1);
}
