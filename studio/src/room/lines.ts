// Lines, words and faces for a scene of three.js.

import { BufferGeometry, CanvasTexture, type Color, DoubleSide, Float32BufferAttribute, type Material, Mesh, MeshBasicMaterial, type Object3D, Sprite, SpriteMaterial, SRGBColorSpace } from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import type { Vec } from "./answers";

export interface Stroke {
  colour: string;
  /** In pixels. */
  width: number;
  opacity?: number;
  dash?: [number, number];
  isOnTop?: boolean;
}

/** Pairs of points, each a line. */
export function segments(pairs: [Vec, Vec][], { colour, width, opacity = 1, dash, isOnTop = false }: Stroke): LineSegments2 {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(pairs.flat(2));
  const material = new LineMaterial({ color: colour, linewidth: width, transparent: opacity < 1 || Boolean(dash), opacity, dashed: Boolean(dash), depthTest: !isOnTop, depthWrite: opacity >= 1 });
  if (dash) [material.dashSize, material.gapSize] = dash;
  const lines = new LineSegments2(geometry, material);
  if (dash) lines.computeLineDistances();
  return lines;
}

export const joined = (points: Vec[], closes = false): [Vec, Vec][] =>
  points.slice(0, closes ? undefined : -1).map((point, k) => [point, points[(k + 1) % points.length]]);

/** Triangles, nine numbers each, of one colour or one for each triangle. */
export function faces(triangles: number[][], colour: string | Color[], how: { opacity?: number; isDouble?: boolean; lifts?: number; isLast?: boolean } = {}): Mesh {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(triangles.flat(), 3));
  const isMany = typeof colour !== "string";
  if (isMany) geometry.setAttribute("color", new Float32BufferAttribute(colour.flatMap(({ r, g, b }) => [r, g, b, r, g, b, r, g, b]), 3));
  const opacity = how.opacity ?? 1;
  const material = new MeshBasicMaterial({ vertexColors: isMany, transparent: opacity < 1, opacity, depthWrite: opacity >= 1, polygonOffset: true, polygonOffsetFactor: how.lifts ?? 1, polygonOffsetUnits: how.lifts ?? 1 });
  if (!isMany) material.color.set(colour);
  if (how.isDouble) material.side = DoubleSide;
  const mesh = new Mesh(geometry, material);
  if (how.isLast) mesh.renderOrder = 2;
  return mesh;
}

/** A convex polygon as triangles. */
export const fan = (corners: Vec[]): number[][] => corners.slice(2).map((corner, k) => [...corners[0], ...corners[k + 1], ...corner]);

/** Words that always face the eye, of a height in pixels at a picture of 600. */
export function label(text: string, at: Vec, colour: string, halo: string, size = 13, weight = 500): Sprite {
  const scale = 2 * Math.min(devicePixelRatio, 2);
  const canvas = document.createElement("canvas");
  const pen = canvas.getContext("2d") as CanvasRenderingContext2D;
  const font = `${weight} ${size * scale}px system-ui, "Segoe UI", Roboto, Arial, sans-serif`;
  pen.font = font;
  canvas.width = Math.ceil(pen.measureText(text).width) + 8 * scale;
  canvas.height = Math.ceil(size * 1.6 * scale);
  pen.font = font;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.lineJoin = "round";
  pen.lineWidth = 2.5 * scale;
  pen.strokeStyle = halo;
  pen.strokeText(text, canvas.width / 2, canvas.height / 2);
  pen.fillStyle = colour;
  pen.fillText(text, canvas.width / 2, canvas.height / 2);
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  const sprite = new Sprite(new SpriteMaterial({ map, sizeAttenuation: false, transparent: true, depthTest: false }));
  sprite.userData.pixels = [canvas.width / scale, canvas.height / scale];
  sprite.position.set(...at);
  sprite.renderOrder = 10;
  return sprite;
}

/** Gives back what the graphics card holds of an object and what is in it. */
export function discard(object: Object3D) {
  object.traverse((one) => {
    const held = one as Object3D & { geometry?: BufferGeometry; material?: Material & { map?: CanvasTexture | null } };
    held.geometry?.dispose();
    held.material?.map?.dispose();
    held.material?.dispose();
  });
  object.removeFromParent();
}
