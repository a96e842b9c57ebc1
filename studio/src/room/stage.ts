// The room's picture in WebGL: drawn again only when something has changed.

import { Group, type Mesh, OrthographicCamera, PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from "three";
import type { LightPaths, RoomScene, RoomWindow, SunTold, SunYear, Vec } from "./answers";
import type { Look } from "./colours";
import { type Dome, domeOf, type Eye, HALF_VIEW_DEG, place } from "./eye";
import { drawField, type Field } from "./field";
import { drawLight, type LightShown } from "./light";
import { discard } from "./lines";
import { type DomeWords, drawGround, drawSun, drawSunPaths } from "./sky_dome";
import { drawRoom } from "./solids";
import { dot, middle } from "./space";

export interface Shown extends LightShown {
  sunPath: boolean;
  field: boolean;
}
export interface Staged {
  scene: RoomScene | null;
  sun: SunTold | null;
  year: SunYear | null;
  light: LightPaths | null;
  field: Field | null;
  shown: Shown;
  eye: Eye;
  look: Look;
  words: DomeWords;
}
export type Met = { kind: "cell"; cell: number } | { kind: "window"; window: RoomWindow } | null;

type Part = "room" | "ground" | "paths" | "sun" | "light" | "field";

export class Stage {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly wide = new PerspectiveCamera(2 * HALF_VIEW_DEG, 1, 0.05, 2000);
  private readonly flat = new OrthographicCamera();
  private readonly parts = new Map<Part, { group: Group; from: unknown[] }>();
  private cells: Mesh[] = [];
  private staged: Staged | null = null;
  private size: [number, number] = [1, 1];
  private waiting = 0;
  /** How often the picture was drawn, for those who count. */
  drawn = 0;

  /** Told where the sun is in the picture, in pixels, whenever it is drawn. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly onSun: (at: [number, number] | null) => void,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    canvas.addEventListener("webglcontextrestored", () => this.ask());
  }

  resize(wide: number, high: number) {
    if (wide === this.size[0] && high === this.size[1]) return;
    this.size = [wide, high];
    this.renderer.setSize(wide, high, false);
    this.ask();
  }

  show(staged: Staged) {
    this.staged = staged;
    const { scene, sun, light, field, shown, look, words } = staged;
    const dome = scene && domeOf(scene);
    this.part("ground", [scene, look], () => dome && drawGround(dome, look, words));
    this.part("room", [scene, look], () => scene && drawRoom(scene, look));
    const hasDome = shown.sunPath && !staged.eye.isFlat;
    const day = sun && hasDome ? JSON.stringify(sun.day) : "";
    this.part("paths", [scene, look, day, staged.year], () => dome && sun && hasDome && drawSunPaths(sun, staged.year ?? { seasons: [], analemmas: [] }, dome, look, words));
    this.part("sun", [scene, look, sun, hasDome], () => dome && sun && hasDome && drawSun(sun, dome, look, aim(scene, sun)));
    this.part("light", [light, scene, look, JSON.stringify(shown)], () => light && scene && drawLight(light, scene.windows, shown, look));
    const isFieldShown = shown.field && field && field.values.length === field.plane.points_m.length;
    this.part("field", [field?.plane, field?.values, JSON.stringify(field?.scale), field?.isStale, field?.picked, isFieldShown, look], () => {
      this.cells = [];
      if (!isFieldShown) return null;
      const made = drawField(field, look);
      this.cells = made.cells;
      return made.group;
    });
    this.ask();
  }

  /** Draws before the next picture of the screen, once. */
  private ask() {
    if (!this.waiting) this.waiting = requestAnimationFrame(() => this.draw());
  }

  private part(name: Part, from: unknown[], make: () => Group | null | false | undefined | "") {
    const old = this.parts.get(name);
    if (old && old.from.length === from.length && old.from.every((one, k) => one === from[k])) return;
    if (old) discard(old.group);
    const group = make() || new Group();
    this.scene.add(group);
    this.parts.set(name, { group, from });
  }

  private camera() {
    const { eye } = this.staged as Staged;
    const [wide, high] = this.size;
    const camera = eye.isFlat ? this.flat : this.wide;
    const [turn, tilt] = [(eye.turn * Math.PI) / 180, (eye.tilt * Math.PI) / 180];
    camera.up.set(-Math.sin(turn) * Math.sin(tilt), -Math.cos(turn) * Math.sin(tilt), Math.cos(tilt));
    camera.position.set(...place(eye.isFlat ? { ...eye, far: 400 } : eye));
    camera.lookAt(...eye.at);
    if (camera === this.flat) {
      const half = eye.far * Math.tan((HALF_VIEW_DEG * Math.PI) / 180);
      [this.flat.top, this.flat.bottom, this.flat.right, this.flat.left] = [half, -half, (half * wide) / high, (-half * wide) / high];
      [this.flat.near, this.flat.far] = [0, 1500];
    } else {
      this.wide.aspect = wide / high;
      [this.wide.near, this.wide.far] = [eye.far / 200, eye.far * 20 + 300];
    }
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    return camera;
  }

  private draw() {
    this.waiting = 0;
    if (!this.staged) return;
    const camera = this.camera();
    const high = this.size[1];
    // words keep their height in pixels
    const tall = camera === this.flat ? (2 * this.flat.top) / high : (2 * Math.tan((HALF_VIEW_DEG * Math.PI) / 180)) / high;
    const walls = this.parts.get("room")?.group.children.flatMap((one) => one.children).filter((one) => one.userData.isWall) ?? [];
    this.scene.traverse((one) => {
      const pixels = one.userData.pixels as [number, number] | undefined;
      if (!pixels) return;
      one.scale.set(pixels[0] * tall, pixels[1] * tall, 1);
      // words behind a wall are left out rather than cut
      const way = one.position.clone().sub(camera.position);
      one.visible = !new Raycaster(camera.position, way.clone().normalize(), 0, way.length()).intersectObjects(walls, false).length;
    });
    this.renderer.render(this.scene, camera);
    this.drawn++;
    this.canvas.dataset.drawn = String(this.drawn);
    const { scene, sun, shown, eye } = this.staged;
    const at = scene && sun && shown.sunPath && !eye.isFlat ? this.onScreen(sun.direction, domeOf(scene), camera) : null;
    this.onSun(at && [((at.x + 1) / 2) * this.size[0], ((1 - at.y) / 2) * high]);
  }

  /** What is at a place of the picture, from −1 to 1 across and up: a cell or a window part. */
  meet(x: number, y: number): Met {
    if (!this.staged) return null;
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(x, y), this.camera());
    const room = this.parts.get("room")?.group.children.flatMap((one) => one.children) ?? [];
    const panes = room.filter((one) => one.userData.window);
    const first = ray.intersectObjects([...panes, ...this.cells], false)[0];
    if (!first) return null;
    if (this.cells.includes(first.object as Mesh)) return { kind: "cell", cell: Math.floor((first.faceIndex ?? 0) / 2) };
    return { kind: "window", window: first.object.userData.window as RoomWindow };
  }

  /** The hour of the day's arc that is nearest to a place of the picture. */
  hourAt(x: number, y: number): number | null {
    const { scene, sun } = this.staged ?? {};
    if (!scene || !sun) return null;
    const camera = this.camera();
    const dome = domeOf(scene);
    let best: { hour: number; far: number } | null = null;
    const places = sun.day.filter((one) => one.altitude_deg > -1).map((one) => ({ hour: one.hour, at: this.onScreen(one.direction, dome, camera) }));
    for (let k = 0; k + 1 < places.length; k++) {
      const [a, b] = [places[k], places[k + 1]];
      const way = b.at.clone().sub(a.at);
      const along = Math.min(1, Math.max(0, new Vector2(x, y).sub(a.at).dot(way) / Math.max(way.lengthSq(), 1e-12)));
      const far = a.at.clone().addScaledVector(way, along).distanceTo(new Vector2(x, y));
      if (!best || far < best.far) best = { hour: a.hour + along * (b.hour - a.hour), far };
    }
    return best?.hour ?? null;
  }

  private onScreen(direction: Vec, dome: Dome, camera: PerspectiveCamera | OrthographicCamera): Vector2 {
    const at = new Vector3(...dome.centre).addScaledVector(new Vector3(...direction), dome.radius).project(camera);
    return new Vector2(at.x, at.y);
  }

  /** The picture as it is, on a ground of its own. */
  picture(): HTMLCanvasElement {
    this.draw();
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [this.canvas.width, this.canvas.height];
    const pen = copy.getContext("2d") as CanvasRenderingContext2D;
    pen.fillStyle = this.staged?.look.ground ?? "#fff";
    pen.fillRect(0, 0, copy.width, copy.height);
    pen.drawImage(this.canvas, 0, 0);
    return copy;
  }

  close() {
    cancelAnimationFrame(this.waiting);
    for (const { group } of this.parts.values()) discard(group);
    this.renderer.dispose();
  }
}

/** Where the line from the sun ends: in the middle of the windows that look to it. */
function aim(scene: RoomScene, sun: SunTold): Vec | null {
  const lit = scene.windows.filter((one) => dot(one.normal, sun.direction) < 0);
  return lit.length ? middle(lit.flatMap((one) => one.outline_m)) : null;
}
