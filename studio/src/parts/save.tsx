// Figures and tables as files.

import type { ComponentChildren } from "preact";
import { useRef } from "preact/hooks";
import { words } from "../words/page";

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

/** Several drawings as one, beside one another. */
function beside(drawings: SVGSVGElement[]): string {
  const boxes = drawings.map((one) => one.viewBox.baseVal);
  const high = Math.max(...boxes.map((box) => box.height));
  const starts = boxes.map((_, k) => boxes.slice(0, k).reduce((sum, box) => sum + (box.width * high) / box.height, 0));
  const wide = boxes.reduce((sum, box) => sum + (box.width * high) / box.height, 0);
  const parts = drawings.map((one, k) => {
    const part = new DOMParser().parseFromString(alone(one), "image/svg+xml").documentElement;
    for (const [key, value] of Object.entries({ x: starts[k], y: 0, width: (boxes[k].width * high) / boxes[k].height, height: high })) part.setAttribute(key, String(value));
    return new XMLSerializer().serializeToString(part);
  });
  const ground = getComputedStyle(document.documentElement).getPropertyValue("--ground").trim();
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${wide} ${high}" width="${wide}" height="${high}"><rect width="${wide}" height="${high}" fill="${ground}"/>${parts.join("")}</svg>`;
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
  const drawn = () => {
    const all = svgs();
    return all.length === 1 ? alone(all[0]) : beside(all);
  };
  const png = () => {
    const own = canvas?.();
    if (own) return own.toBlob((blob) => blob && saveFile(`${name}.png`, blob));
    if (svgs().length) void pixels(drawn(), 3).then((blob) => saveFile(`${name}.png`, blob));
  };
  return (
    <section class="figure" ref={place} aria-label={title}>
      <header>
        <h3>{title}</h3>
        <div class="saves" role="group" aria-label={`${words.exports}: ${title}`}>
          {!noPicture && <button onClick={png}>PNG</button>}
          {!canvas && !noPicture && <button onClick={() => svgs().length && saveFile(`${name}.svg`, drawn(), "image/svg+xml")}>SVG</button>}
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
