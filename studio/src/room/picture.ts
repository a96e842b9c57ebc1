// The room's picture as a file: with its title, its legend and its colour bar.

import { cividis } from "../draw/colours";
import { written } from "../draw/written";
import { type Look, pathColour } from "./colours";
import { type Scale, share, ticks } from "./scale";

export interface Caption {
  title: string;
  lines: string[];
  legend: { text: string; kind: "direct" | "redirected" | "reflected" }[];
  bar: { scale: Scale; unit: string; title: string } | null;
}

export function captioned(picture: HTMLCanvasElement, caption: Caption, look: Look): HTMLCanvasElement {
  const made = document.createElement("canvas");
  const scale = Math.max(picture.width / 1000, 0.6);
  const [head, foot] = [(36 + 18 * caption.lines.length) * scale, 74 * scale];
  [made.width, made.height] = [picture.width, Math.round(head + picture.height + foot)];
  const pen = made.getContext("2d") as CanvasRenderingContext2D;
  const write = (text: string, x: number, y: number, size: number, colour = look.ink, weight = 400, align: CanvasTextAlign = "left") => {
    pen.font = `${weight} ${size * scale}px system-ui, "Segoe UI", Roboto, Arial, sans-serif`;
    pen.textAlign = align;
    pen.fillStyle = colour;
    pen.fillText(text, x, y);
  };
  pen.fillStyle = look.ground;
  pen.fillRect(0, 0, made.width, made.height);
  pen.drawImage(picture, 0, head);
  write(caption.title, 16 * scale, 26 * scale, 17, look.ink, 600);
  caption.lines.forEach((line, k) => write(line, 16 * scale, (46 + 18 * k) * scale, 13, look.faint));
  let x = 16 * scale;
  const base = head + picture.height + 30 * scale;
  for (const one of caption.legend) {
    pen.strokeStyle = pathColour(one.kind, look.isDark);
    pen.lineWidth = 3 * scale;
    pen.setLineDash(one.kind === "reflected" ? [6 * scale, 4 * scale] : []);
    pen.beginPath();
    pen.moveTo(x, base - 4 * scale);
    pen.lineTo(x + 26 * scale, base - 4 * scale);
    pen.stroke();
    write(one.text, x + 33 * scale, base, 13);
    x += 46 * scale + pen.measureText(one.text).width;
  }
  if (caption.bar) {
    const { scale: range, unit, title } = caption.bar;
    const wide = 330 * scale;
    const left = made.width - wide - 24 * scale;
    for (let k = 0; k < 96; k++) {
      pen.fillStyle = cividis((k + 0.5) / 96);
      pen.fillRect(left + (k * wide) / 96, base - 8 * scale, wide / 96 + 1, 10 * scale);
    }
    write(title, left, base - 14 * scale, 12, look.faint);
    const marks = ticks(range, 5);
    marks.forEach((mark, k) => write(`${written(mark)}${k === marks.length - 1 ? ` ${unit}` : ""}`, left + share(range, mark) * wide, base + 18 * scale, 12, look.ink, 400, "center"));
  }
  return made;
}
