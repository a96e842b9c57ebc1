// Hands on the room's picture: turning, moving, zooming, pointing at things.

import { byKey, type Eye, metresPerPixel, moved, rounded } from "./eye";
import type { Met, Stage } from "./stage";

export interface Handled {
  eye: () => Eye;
  stage: () => Stage;
  onEye: (eye: Eye) => void;
  onMeet: (met: Met, x: number, y: number) => void;
  onPick: (cell: number) => void;
}

/** Degrees that a pixel of dragging turns. */
const DEG_PER_PIXEL = 0.35;

/** Listens on a canvas until the function that it gives back is called. */
export function handle(canvas: HTMLCanvasElement, hands: Handled): () => void {
  const held = new Map<number, { x: number; y: number }>();
  let doing: "turn" | "move" | null = null;
  let isClick = false;

  const relative = (event: { clientX: number; clientY: number }): [number, number] => {
    const box = canvas.getBoundingClientRect();
    return [(2 * (event.clientX - box.left)) / box.width - 1, 1 - (2 * (event.clientY - box.top)) / box.height];
  };
  const inside = (event: PointerEvent): [number, number] => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const put = (eye: Eye) => hands.onEye(rounded(eye));

  const down = (event: PointerEvent) => {
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    held.set(event.pointerId, { x: event.clientX, y: event.clientY });
    isClick = held.size === 1;
    if (held.size > 1) doing = "move";
    else if (event.button === 2 || event.button === 1 || event.shiftKey) doing = "move";
    else doing = "turn";
    canvas.dataset.doing = doing;
  };
  const move = (event: PointerEvent) => {
    const old = held.get(event.pointerId);
    if (!old) {
      const met = hands.stage().meet(...relative(event));
      canvas.style.cursor = met ? "crosshair" : "grab";
      hands.onMeet(met, ...inside(event));
      return;
    }
    const [dx, dy] = [event.clientX - old.x, event.clientY - old.y];
    if (isClick && Math.hypot(dx, dy) < 3) return;
    isClick = false;
    hands.onMeet(null, 0, 0);
    const eye = hands.eye();
    const high = canvas.clientHeight;
    if (held.size > 1) {
      const other = [...held].find(([id]) => id !== event.pointerId)?.[1] as { x: number; y: number };
      const before = Math.hypot(old.x - other.x, old.y - other.y);
      const after = Math.hypot(event.clientX - other.x, event.clientY - other.y);
      const step = metresPerPixel(eye, high) / 2;
      put(moved({ ...eye, far: (eye.far * Math.max(before, 1)) / Math.max(after, 1) }, -dx * step, dy * step));
    } else if (doing === "move") {
      const step = metresPerPixel(eye, high);
      put(moved(eye, -dx * step, dy * step));
    } else put({ ...eye, turn: eye.turn + dx * DEG_PER_PIXEL, tilt: eye.tilt + dy * DEG_PER_PIXEL });
    held.set(event.pointerId, { x: event.clientX, y: event.clientY });
  };
  const up = (event: PointerEvent) => {
    held.delete(event.pointerId);
    if (isClick) {
      const met = hands.stage().meet(...relative(event));
      if (met?.kind === "cell") hands.onPick(met.cell);
      hands.onMeet(met, ...inside(event));
    }
    doing = held.size ? "turn" : null;
    isClick = false;
    delete canvas.dataset.doing;
  };
  const leave = () => hands.onMeet(null, 0, 0);
  // the wheel zooms once the picture has been clicked; before, it scrolls the page
  const wheel = (event: WheelEvent) => {
    if (document.activeElement !== canvas && !event.ctrlKey) return;
    event.preventDefault();
    const eye = hands.eye();
    put({ ...eye, far: eye.far * Math.exp(Math.sign(event.deltaY) * Math.min(Math.abs(event.deltaY), 120) * 0.0012) });
  };
  const key = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const eye = byKey(hands.eye(), event);
    if (!eye) return;
    event.preventDefault();
    put(eye);
  };
  const still = (event: Event) => event.preventDefault();
  const heard: [string, (event: never) => void, AddEventListenerOptions?][] = [
    ["pointerdown", down],
    ["pointermove", move],
    ["pointerup", up],
    ["pointercancel", up],
    ["pointerleave", leave],
    ["wheel", wheel, { passive: false }],
    ["keydown", key],
    ["contextmenu", still],
  ];
  for (const [name, listener, how] of heard) canvas.addEventListener(name, listener as EventListener, how);
  return () => heard.forEach(([name, listener]) => canvas.removeEventListener(name, listener as EventListener));
}
