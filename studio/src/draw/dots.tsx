// Shares of several variants on one line each, with their standard errors.

import { categoryOf, markOf } from "./colours";
import { fit } from "./plans";

export interface DotRow {
  label: string;
  dots: { value: number | null; error: number | null; text: string }[];
}

const [WIDE, LEFT, RIGHT, EACH, FOOT] = [420, 190, 14, 54, 40];

export function DrawDots({ rows, names, label, axis }: { rows: DotRow[]; names: string[]; label: string; axis: string }) {
  const perRow = names.some((name) => name.length > 26) || names.length > 3 ? 2 : Math.max(names.length, 1);
  const top = 20 + 20 * Math.ceil(names.length / perRow);
  const high = top + rows.length * EACH + FOOT;
  const x = (share: number) => LEFT + (Math.min(Math.max(share, 0), 100) / 100) * (WIDE - LEFT - RIGHT);
  const shift = (number: number) => (names.length > 1 ? ((number - (names.length - 1) / 2) * Math.min(9, 24 / names.length)) : 0);
  return (
    <svg class="drawing" style={{ maxWidth: `${WIDE * 1.3}px`, margin: "auto" }} viewBox={`0 0 ${WIDE} ${high}`} role="img" aria-label={label}>
      {[0, 25, 50, 75, 100].map((tick) => (
        <g key={tick}>
          <path class="hair" d={`M${x(tick)} ${top}V${high - FOOT}`} />
          <text class="small" x={x(tick)} y={high - FOOT + 17} text-anchor="middle">
            {tick}
          </text>
        </g>
      ))}
      <text class="small faint" x={x(50)} y={high - 5} text-anchor="middle">
        {axis}
      </text>
      {rows.map((row, place) => {
        const y = top + (place + 0.5) * EACH;
        return (
          <g key={row.label}>
            <path class="hair" d={`M${LEFT} ${y}H${WIDE - RIGHT}`} />
            {inLines(row.label).map((text, k, all) => (
              <text key={k} class="small" x={LEFT - 10} y={y + 14 * (k - (all.length - 1) / 2)} text-anchor="end" dominant-baseline="central">
                {fit(text, LEFT - 10, 6.1)}
                <title>{row.label}</title>
              </text>
            ))}
            {row.dots.map((dot, number) =>
              dot.value === null ? null : (
                <g key={number} transform={`translate(${x(dot.value).toFixed(1)} ${(y + shift(number)).toFixed(1)})`}>
                  {dot.error ? <path stroke={categoryOf(number)} stroke-width={1.6} d={`M${(x(dot.value - dot.error) - x(dot.value)).toFixed(1)} 0H${(x(dot.value + dot.error) - x(dot.value)).toFixed(1)}`} /> : null}
                  <path class="seriesMark" fill={categoryOf(number)} d={markOf(number)}>
                    <title>{`${names[number]}: ${dot.text} %`}</title>
                  </path>
                </g>
              ),
            )}
          </g>
        );
      })}
      {names.map((name, number) => {
        const width = (WIDE - 20) / perRow;
        return (
          <g key={name} transform={`translate(${14 + (number % perRow) * width} ${12 + 20 * Math.floor(number / perRow)})`}>
            <path class="seriesMark" fill={categoryOf(number)} d={markOf(number)} />
            <text class="small" x={12} y={0} dominant-baseline="central">
              {fit(name, width - 20, 6.8)}
            </text>
          </g>
        );
      })}
    </svg>
  );
}

/** A long label in two lines. */
function inLines(text: string): string[] {
  if (text.length <= 25) return [text];
  const cut = text.lastIndexOf(" ", 25);
  return cut > 0 ? [text.slice(0, cut), text.slice(cut + 1)] : [text];
}
