// Figures and tables as files.

import { useRef } from "preact/hooks";
import type { ComponentChildren } from "preact";
import { words } from "./words";

const KEPT = ["fill", "fill-opacity", "stroke", "stroke-width", "stroke-opacity", "stroke-dasharray", "font-size", "font-family", "font-weight", "text-anchor", "dominant-baseline", "opacity", "paint-order", "stroke-linejoin"];

/** A drawing by itself, its styles written into it. */
function alone(drawing: SVGSVGElement): string {
  const copy = drawing.cloneNode(true) as SVGSVGElement;
  const [from, to] = [drawing, copy].map((one) => [one, ...Array.from(one.querySelectorAll("*"))] as SVGElement[]);
  from.forEach((element, k) => {
    const style = getComputedStyle(element);
    for (const name of KEPT) to[k].setAttribute(name, style.getPropertyValue(name));
    for (const name of ["class", "role", "tabindex", "style"]) to[k].removeAttribute(name);
  });
  const box = drawing.viewBox.baseVal;
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("width", String(box.width));
  copy.setAttribute("height", String(box.height));
  const ground = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  for (const [name, value] of Object.entries({ x: box.x, y: box.y, width: box.width, height: box.height })) ground.setAttribute(name, String(value));
  ground.setAttribute("fill", getComputedStyle(document.documentElement).getPropertyValue("--ground").trim());
  copy.insertBefore(ground, copy.firstChild);
  return new XMLSerializer().serializeToString(copy);
}

async function pixels(svg: string, scale: number): Promise<Blob> {
  const picture = new Image();
  picture.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`;
  await picture.decode();
  const canvas = document.createElement("canvas");
  canvas.width = picture.width * scale;
  canvas.height = picture.height * scale;
  canvas.getContext("2d")?.drawImage(picture, 0, 0, canvas.width, canvas.height);
  return new Promise((done, fail) => canvas.toBlob((blob) => (blob ? done(blob) : fail(new Error("no picture"))), "image/png"));
}

export function saveFile(name: string, content: Blob | string, type = "text/plain") {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** A table as CSV: a heading and its columns. */
export function csv(columns: Record<string, (number | string)[]>): string {
  const names = Object.keys(columns);
  const rows = columns[names[0]].map((_, k) => names.map((name) => columns[name][k]).join(","));
  return `${[names.join(","), ...rows].join("\n")}\n`;
}

interface Props {
  name: string;
  title: string;
  hint?: string;
  table?: () => Record<string, (number | string)[]>;
  canvas?: () => HTMLCanvasElement | null;
  noPicture?: boolean;
  extra?: { label: string; save: () => void }[];
  children: ComponentChildren;
}

/** A figure with a heading and the ways to save it. */
export function Figure({ name, title, hint, table, canvas, noPicture, extra, children }: Props) {
  const place = useRef<HTMLElement>(null);
  const svgs = () => Array.from(place.current?.querySelectorAll<SVGSVGElement>("svg.drawing") ?? []);
  const each = (save: (svg: string, name: string) => void) =>
    svgs().forEach((drawing, k) => save(alone(drawing), svgs().length > 1 ? `${name}-${k + 1}` : name));
  const png = () => {
    const own = canvas?.();
    if (own) return own.toBlob((blob) => blob && saveFile(`${name}.png`, blob));
    each((svg, file) => void pixels(svg, 3).then((blob) => saveFile(`${file}.png`, blob)));
  };
  return (
    <section class="figure" ref={place} aria-label={title}>
      <header>
        <h3>{title}</h3>
        <div class="saves" role="group" aria-label={`${words.exports}: ${title}`}>
          {!noPicture && <button onClick={png}>PNG</button>}
          {!canvas && !noPicture && <button onClick={() => each((svg, file) => saveFile(`${file}.svg`, svg, "image/svg+xml"))}>SVG</button>}
          {table && <button onClick={() => saveFile(`${name}.csv`, csv(table()), "text/csv")}>CSV</button>}
          {extra?.map((one) => (
            <button key={one.label} onClick={one.save}>
              {one.label}
            </button>
          ))}
        </div>
      </header>
      {hint && <p class="hint">{hint}</p>}
      {children}
    </section>
  );
}
