// What drawings of shares have in common: axes against elevation, and the keys to their lines.

const [WIDE, LEFT, RIGHT, FOOT, HEAD] = [560, 44, 14, 40, 44];

/** A drawing of shares against the elevation that light comes from: its size, and where a value stands in it. */
export interface Axes {
  wide: number;
  high: number;
  left: number;
  x: (deg: number) => number;
  y: (share: number) => number;
}

export function axesOf(high: number): Axes {
  return {
    wide: WIDE,
    high,
    left: LEFT,
    x: (deg) => LEFT + ((deg + 90) / 180) * (WIDE - LEFT - RIGHT),
    y: (share) => high - FOOT - share * (high - FOOT - HEAD),
  };
}

/** The line through values at elevations. */
export function lineOf({ x, y }: Axes, elevation_deg: number[], values: number[]): string {
  return `M${elevation_deg.map((deg, k) => `${x(deg).toFixed(1)} ${y(values[k]).toFixed(1)}`).join("L")}`;
}

/** The ground of the drawing: lines of equal share, elevations, and what they are. */
export function ShareAxes({ axes, axis }: { axes: Axes; axis: string }) {
  const { wide, high, left, x, y } = axes;
  return (
    <>
      {[0, 0.25, 0.5, 0.75, 1].map((share) => (
        <g key={share}>
          <path class="hair" d={`M${left} ${y(share)}H${wide - RIGHT}`} />
          <text class="small" x={left - 6} y={y(share)} text-anchor="end" dominant-baseline="central">
            {100 * share}
          </text>
        </g>
      ))}
      {[-90, -60, -30, 0, 30, 60, 90].map((deg) => (
        <text key={deg} class="small" x={x(deg)} y={high - FOOT + 15} text-anchor="middle">
          {deg}°
        </text>
      ))}
      <text class="small faint" x={(wide + left) / 2} y={high - 6} text-anchor="middle">
        {axis}
      </text>
      <text class="small faint" x={left - 6} y={HEAD - 14} text-anchor="end">
        %
      </text>
    </>
  );
}

/** The elevation that is looked at. */
export const Here = ({ axes, elevation }: { axes: Axes; elevation: number }) => <path class="here" d={`M${axes.x(elevation)} ${axes.y(0)}V${axes.y(1)}`} />;

interface KeyProps {
  x: number;
  y: number;
  length?: number;
  stroke?: string;
  dash?: string;
  text: string;
}

/** A piece of a line and what it stands for. */
export function LineKey({ x, y, length = 18, stroke = "currentColor", dash = "", text }: KeyProps) {
  return (
    <g>
      <path class="curve" stroke={stroke} stroke-dasharray={dash} d={`M${x} ${y}h${length}`} />
      <text class="small" x={x + length + 6} y={y} dominant-baseline="central">
        {text}
      </text>
    </g>
  );
}
