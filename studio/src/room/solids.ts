// The room itself in 3D: its surfaces seen from within, its edges, its window parts, what stands before them.

import { Color, FrontSide, Group, type MeshBasicMaterial } from "three";
import type { RoomScene, RoomSurface, RoomWindow, Vec } from "./answers";
import { glassColour, isCut, type Look } from "./colours";
import { fan, faces, joined, segments } from "./lines";
import { cross, dot, long, middle, minus, normalOf, plus, unit } from "./space";

/** Thickest wall through which a window is taken to belong to a room's side [m]. */
const WALL_M = 0.6;
/** Share of the largest surface's area from which on a surface is taken to be a side of the room, and no thing in it. */
const LARGE = 0.15;
/** Distance of the lines that hint at cuts or ridges, which are finer than a picture can show [m]. */
const HATCH_M = 0.06;

export function drawRoom(scene: RoomScene, look: Look): Group {
  const group = new Group();
  const isOut = (surface: RoomSurface) => scene.windows.some((one) => surface.outlines.flat().every((corner) => dot(minus(corner, one.outline_m[0]), one.normal) < 0.02));
  const all = scene.surfaces.filter((one) => one.kind !== "window");
  const inside = all.filter((one) => !isOut(one));
  const corners = inside.flatMap((one) => one.outlines.flat());
  const seen = scene.planes.flatMap((one) => one.points_m);
  const most = Math.max(...inside.map(areaOf));
  for (const surface of all.filter(isOut)) {
    group.add(faces(surface.triangles, look.outside, { opacity: 0.16, isDouble: true }));
    group.add(segments(surface.outlines.flatMap((loop) => joined(loop, true)), { colour: look.outside, width: 1, opacity: 0.7 }));
  }
  for (const surface of inside) group.add(drawSurface(surface, look, seen.length ? seen : [middle(scene.inside_m)], corners, areaOf(surface) >= LARGE * most));
  for (const window of scene.windows) group.add(drawWindow(window, look));
  return group;
}

/** A side of the room is seen from within alone, so that one always looks in; a thing in the room from both sides. */
function drawSurface(surface: RoomSurface, look: Look, seen: Vec[], all: Vec[], isLarge: boolean): Group {
  const group = new Group();
  const shade = new Color(look.walls[0]).lerp(new Color(look.walls[1]), Math.min((surface.diffuse ?? 0.5) + (surface.specular ?? 0), 0.9) / 0.9);
  const corners = surface.outlines.flat();
  const normal = normalOf(surface.outlines[0] ?? corners);
  // the room is where most sensors are near
  const centre = middle(corners);
  const side = seen.reduce((sum, point) => sum + dot(minus(point, centre), normal) / Math.max(long(minus(point, centre)), 0.1) ** 3, 0);
  const inwards = side > 0 ? normal : plus([0, 0, 0], normal, -1);
  const reach = Math.min(...all.map((corner) => dot(minus(corner, centre), inwards)));
  const isSide = isLarge || reach > -WALL_M;
  // light from one side makes edges plain
  const tone = 1 - 0.035 * (1 + dot(inwards, unit([0.3, 0.9, -0.4])));
  shade.multiplyScalar(tone);
  const turned = isSide
    ? surface.triangles.map((one) => {
        const [a, b, c] = [0, 3, 6].map((k) => one.slice(k, k + 3) as Vec);
        return dot(normalOf([a, b, c]), inwards) > 0 ? one : [...a, ...c, ...b];
      })
    : surface.triangles;
  const mesh = faces(turned, `#${shade.getHexString()}`, { isDouble: !isSide, lifts: 2 });
  if (isSide) (mesh.material as MeshBasicMaterial).side = FrontSide;
  mesh.userData.isWall = isSide;
  group.add(mesh);
  group.add(segments(surface.outlines.flatMap((loop) => joined(loop, true)), { colour: look.edge, width: isSide ? 1.5 : 1, opacity: isSide ? 0.9 : 0.6 }));
  return group;
}

/** Of its first outline, or of its triangles [m²]. */
function areaOf(surface: RoomSurface): number {
  if (surface.kind === "window") return 0;
  return surface.triangles.reduce((sum, one) => {
    const [a, b, c] = [0, 3, 6].map((k) => one.slice(k, k + 3) as Vec);
    return sum + long(cross(minus(b, a), minus(c, a))) / 2;
  }, 0);
}

function drawWindow(window: RoomWindow, look: Look): Group {
  const group = new Group();
  const colour = glassColour(window.kind, look.isDark);
  const pane = faces(fan(window.outline_m), colour, { opacity: isCut(window.kind) ? 0.42 : 0.26, isDouble: true });
  pane.userData.window = window;
  pane.renderOrder = 1;
  group.add(pane);
  group.add(segments(joined(window.outline_m, true), { colour, width: 2.4 }));
  if (isCut(window.kind)) group.add(segments(hatched(window), { colour, width: 1, opacity: 0.85 }));
  return group;
}

/** Lines along the cuts: level ones across the part. */
function hatched(window: RoomWindow): [Vec, Vec][] {
  const corners = window.outline_m;
  // up along the pane; across a level pane, along its first edge
  const up = Math.abs(window.normal[2]) < 0.99 ? unit(minus([0, 0, 1], plus([0, 0, 0], window.normal, window.normal[2]))) : unit(minus(corners[2], corners[1]));
  const heights = corners.map((corner) => dot(corner, up));
  const [least, most] = [Math.min(...heights), Math.max(...heights)];
  const found: [Vec, Vec][] = [];
  for (let at = least + HATCH_M; at < most - 1e-6; at += HATCH_M) {
    const crossings: Vec[] = [];
    corners.forEach((a, k) => {
      const b = corners[(k + 1) % corners.length];
      const [from, to] = [dot(a, up), dot(b, up)];
      if (from > at !== to > at) crossings.push(plus(a, minus(b, a), (at - from) / (to - from)));
    });
    for (let k = 0; k + 1 < crossings.length; k += 2) found.push([crossings[k], crossings[k + 1]]);
  }
  return found;
}
