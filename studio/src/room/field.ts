// False colours over a plane of the room.

import { BackSide, Color, FrontSide, Group, type Material, type Mesh, SRGBColorSpace } from "three";
import { cividis } from "../draw/colours";
import type { Plane, Vec } from "./answers";
import { cellsOf } from "./cells";
import type { Look } from "./colours";
import { fan, faces, joined, segments } from "./lines";
import { type Scale, share } from "./scale";
import { between, dot, middle, normalOf } from "./space";

export interface Field {
  plane: Plane;
  values: number[];
  scale: Scale;
  isStale: boolean;
  picked: number;
}

export function drawField(field: Field, look: Look): { group: Group; cells: Mesh[] } {
  const group = new Group();
  const cells = cellsOf(field.plane);
  const inset = cells.map((corners) => corners.map((corner) => between(corner, middle(corners), 0.045)));
  const colours = field.values.flatMap((value) => {
    const colour = new Color().setStyle(cividis(share(field.scale, value)), SRGBColorSpace);
    return [colour, colour];
  });
  const triangles = inset.flatMap((corners) => fan(corners));
  const opacity = field.isStale ? 0.45 : 0.94;
  const mesh = faces(triangles, colours, { opacity, lifts: -1 });
  // from behind, as a ceiling from above, one looks through
  const behind = faces(triangles, colours, { opacity: 0.5 * opacity, lifts: -1 });
  const isTurned = dot(normalOf(cells[0]), field.plane.normals[0]) < 0;
  (mesh.material as Material).side = isTurned ? BackSide : FrontSide;
  (behind.material as Material).side = isTurned ? FrontSide : BackSide;
  (mesh.material as Material).depthWrite = true;
  mesh.renderOrder = behind.renderOrder = 0;
  const both = new Group();
  both.add(mesh, behind);
  group.add(both);
  // seen from its edge a plane is a line
  group.add(segments(rim(cells), { colour: look.edge, width: 1.4, opacity: 0.9 }));
  const picked = cells[field.picked];
  if (picked) {
    const ring = segments(joined(picked, true), { colour: look.isDark ? "#ffffff" : "#e8590c", width: 3, isOnTop: true });
    ring.renderOrder = 6;
    group.add(ring);
  }
  return { group, cells: both.children as Mesh[] };
}

/** Edges that belong to one cell alone. */
function rim(cells: Vec[][]): [Vec, Vec][] {
  const seen = new Map<string, { ends: [Vec, Vec]; times: number }>();
  for (const corners of cells)
    for (const ends of joined(corners, true)) {
      const key = ends.map((one) => one.map((x) => Math.round(1000 * x)).join(" ")).sort().join(",");
      seen.set(key, { ends, times: (seen.get(key)?.times ?? 0) + 1 });
    }
  return [...seen.values()].filter((one) => one.times === 1).map((one) => one.ends);
}
