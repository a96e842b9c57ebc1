// The place of the room's picture: three.js comes when it is wanted, hands and keys move the eye, things say what they are.

import { useEffect, useRef, useState } from "preact/hooks";
import type { Eye } from "./eye";
import { handle } from "./hands";
import type { Met, Stage, Staged } from "./stage";

interface Props {
  staged: Staged;
  label: string;
  help: string;
  waiting: string;
  missing: string;
  told: (met: Met) => string;
  onAspect: (aspect: number) => void;
  onEye: (eye: Eye) => void;
  onHour: (hour: number) => void;
  hour: number;
  sunLabel: string;
  sunText: string;
  onPick: (cell: number) => void;
  onKey: (key: string) => void;
  /** Takes the function that gives the picture as a canvas. */
  onReady: (picture: () => HTMLCanvasElement) => void;
}

export function Room3D(props: Props) {
  const { staged, label, help, waiting, missing } = props;
  const canvas = useRef<HTMLCanvasElement>(null);
  const sun = useRef<HTMLDivElement>(null);
  const stage = useRef<Stage | null>(null);
  const newest = useRef(props);
  newest.current = props;
  const [state, setState] = useState<"waiting" | "ready" | "missing">("waiting");
  const [tip, setTip] = useState<{ text: string; x: number; y: number } | null>(null);

  useEffect(() => {
    const place = canvas.current as HTMLCanvasElement;
    let isWanted = true;
    let leave = () => {};
    void import("./stage").then(({ Stage }) => {
      if (!isWanted) return;
      let made: Stage;
      try {
        made = new Stage(place, (at) => {
          const handle = sun.current;
          if (!handle) return;
          handle.hidden = !at;
          if (at) [handle.style.left, handle.style.top] = at.map((one) => `${one}px`);
        });
      } catch {
        setState("missing");
        return;
      }
      stage.current = made;
      const sized = new ResizeObserver(() => {
        const { clientWidth, clientHeight } = place.parentElement as HTMLElement;
        if (!clientWidth || !clientHeight) return;
        made.resize(clientWidth, clientHeight);
        newest.current.onAspect(clientWidth / clientHeight);
      });
      sized.observe(place.parentElement as HTMLElement);
      const unhand = handle(place, {
        eye: () => newest.current.staged.eye,
        stage: () => made,
        onEye: (eye) => newest.current.onEye(eye),
        onPick: (cell) => newest.current.onPick(cell),
        onMeet: (met, x, y) => {
          const text = newest.current.told(met);
          setTip(text ? { text, x, y } : null);
        },
      });
      leave = () => {
        sized.disconnect();
        unhand();
        made.close();
        stage.current = null;
      };
      made.show(newest.current.staged);
      newest.current.onReady(() => made.picture());
      setState("ready");
    });
    return () => {
      isWanted = false;
      leave();
    };
  }, []);
  useEffect(() => stage.current?.show(staged));

  const drag = (event: PointerEvent) => {
    const box = canvas.current?.getBoundingClientRect();
    if (!box || (event.type === "pointermove" && !(event.buttons & 1))) return;
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    const hour = stage.current?.hourAt((2 * (event.clientX - box.left)) / box.width - 1, 1 - (2 * (event.clientY - box.top)) / box.height) ?? null;
    if (event.type === "pointermove" && hour !== null) props.onHour(hour);
  };
  const step = (event: KeyboardEvent) => {
    const hours = { ArrowRight: 1 / 12, ArrowUp: 1 / 12, ArrowLeft: -1 / 12, ArrowDown: -1 / 12, PageUp: 1, PageDown: -1 }[event.key];
    if (hours === undefined) return;
    event.preventDefault();
    props.onHour(props.hour + hours);
  };

  if (state === "missing")
    return (
      <p class="hint big" role="status">
        {missing}
      </p>
    );
  return (
    <div class="stage">
      <canvas
        ref={canvas}
        tabIndex={0}
        role="img"
        aria-label={label}
        aria-describedby="stage-help"
        onKeyDown={(event) => props.onKey(event.key)}
      />
      <div
        ref={sun}
        class="sunHandle"
        hidden
        role="slider"
        tabIndex={0}
        aria-label={props.sunLabel}
        aria-valuemin={0}
        aria-valuemax={24}
        aria-valuenow={Math.round(100 * props.hour) / 100}
        aria-valuetext={props.sunText}
        title={props.sunText}
        onPointerDown={drag}
        onPointerMove={drag}
        onKeyDown={step}
      />
      <span id="stage-help" class="unseen">
        {help}
      </span>
      {state === "waiting" && <p class="hint over">{waiting}</p>}
      {tip && (
        <div class="tip" style={{ left: `${tip.x}px`, top: `${tip.y}px` }}>
          {tip.text}
        </div>
      )}
    </div>
  );
}
