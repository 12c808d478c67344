import type { Direction } from "../../../../lib/direction.ts";
import { microstrain, significant, ticks } from "../../../../lib/format.ts";
import { short } from "../../../../lib/layouts/layout-words.ts";
import type { SurfacePoint } from "../../../../lib/tire/map/map-grid.ts";
import { strainOver, unitOf } from "../../../../lib/tire/surface/section-lines.ts";
import type { Sections } from "../../../../wire.ts";

const [WIDTH, HEIGHT] = [320, 190];
const EDGE = { left: 62, right: 14, top: 10, bottom: 38 };

/** The strain of the pinned place at each solved value of the input. */
export function DepthPlot({ line, point, direction, value }: { line: Sections; point: SurfacePoint; direction: Direction; value: number | null }) {
  const dots = strainOver(line, point, direction);
  if (dots.length < 2) return <p class="quiet">The pinned place lies beyond the map.</p>;
  const unit = unitOf(line.vary);
  const across = axis(dots.map((dot) => dot.value), EDGE.left, WIDTH - EDGE.right);
  const up = axis(dots.map((dot) => dot.strain * 1e6), HEIGHT - EDGE.bottom, EDGE.top);
  const path = dots.map((dot) => `${across.at(dot.value)},${up.at(dot.strain * 1e6)}`).join(" ");
  const title = `Strain ${direction} at the pinned place over ${line.input}`;
  return (
    <figure class="depth-plot">
      <figcaption>{title}, µε; dots are solves</figcaption>
      <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={`${title}: ${dots.map((dot) => `${significant(dot.value)} ${unit} ${microstrain(dot.strain)} µε`).join(", ")}`}>
        <g class="axis">
          {across.marks.map((mark) => (
            <text key={mark} x={across.at(mark)} y={HEIGHT - EDGE.bottom + 16} text-anchor="middle">
              {short(mark)}
            </text>
          ))}
          {up.marks.map((mark) => (
            <g key={mark}>
              <line x1={EDGE.left} x2={WIDTH - EDGE.right} y1={up.at(mark)} y2={up.at(mark)} />
              <text x={EDGE.left - 6} y={up.at(mark) + 4} text-anchor="end">
                {microstrain(mark * 1e-6)}
              </text>
            </g>
          ))}
          <text x={(EDGE.left + WIDTH - EDGE.right) / 2} y={HEIGHT - 4} text-anchor="middle">
            {line.input}
            {unit === "" ? "" : `, ${unit}`}
          </text>
        </g>
        {value !== null && <line class="slider-line" x1={across.at(value)} x2={across.at(value)} y1={EDGE.top} y2={HEIGHT - EDGE.bottom} />}
        <polyline class="trade-front" points={path} />
        {dots.map((dot) => (
          <circle key={dot.value} class="trade-true" cx={across.at(dot.value)} cy={up.at(dot.strain * 1e6)} r={3.5} />
        ))}
      </svg>
    </figure>
  );
}

/** A straight axis over values with round marks. */
function axis(values: readonly number[], from: number, to: number): { at: (value: number) => number; marks: number[] } {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const span = high > low ? high - low : 1;
  return { at: (value) => from + ((value - low) / span) * (to - from), marks: ticks(low, high, 4) };
}
