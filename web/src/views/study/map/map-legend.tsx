import { css } from "../../../lib/colour.ts";
import { fixed, microstrain, ticks } from "../../../lib/format.ts";
import { shareOf, type Scale } from "../../../lib/study/surface-field.ts";

const WIDTH = 360;
const SIDE = 22;
const STRIPES = 120;

/** The colours of a scale with their values. */
export function Legend({ scale, title }: { scale: Scale; title: string }) {
  const inner = WIDTH - 2 * SIDE;
  const factor = scale.unit === "percent" ? 100 : 1e6;
  const marks = ticks(scale.low * factor, scale.high * factor, 4);
  return (
    <figure class="legend">
      <figcaption>{title}</figcaption>
      <svg viewBox={`0 0 ${WIDTH} 34`} role="img" aria-label={`Colours from ${label(scale, scale.low)} to ${label(scale, scale.high)}`}>
        {Array.from({ length: STRIPES }, (_, index) => (
          <rect
            key={index}
            x={SIDE + (inner * index) / STRIPES}
            width={inner / STRIPES + 0.5}
            height={14}
            fill={css(scale.colour((index + 0.5) / STRIPES))}
          />
        ))}
        <g class="axis">
          {marks.map((mark) => {
            const at = SIDE + inner * shareOf(scale, mark / factor);
            return (
              <g key={mark}>
                <line x1={at} x2={at} y1={14} y2={18} />
                <text x={at} y={30} text-anchor="middle">
                  {label(scale, mark / factor)}
                </text>
              </g>
            );
          })}
        </g>
      </svg>
    </figure>
  );
}

function label(scale: Scale, value: number): string {
  if (scale.unit === "microstrain") return value === 0 ? "0" : microstrain(value);
  const span = 100 * (scale.high - scale.low);
  return fixed(100 * value, span >= 20 ? 0 : span >= 2 ? 1 : 2);
}
