import { css, type Rgb } from "../../../lib/colour.ts";
import { fixed, microstrain, significant, ticks } from "../../../lib/format.ts";
import { shareOf, SHOWN_FACTOR, type Field, type Scale } from "../../../lib/tire/map/surface-field.ts";
import { GREY } from "../../../lib/tire/map/trust.ts";
import { BARE } from "./wheel/skin-colours.ts";

const WIDTH = 320;
const SIDE = 22;
const STRIPES = 120;

interface Props {
  field: Field;
  title: string;
  /** Where the map ends. */
  beyond_deg: number;
  isKept: boolean;
  onKeep: (isKept: boolean) => void;
}

/** The colours of a scale with their values, and what grey means. */
export function TireLegend({ field, title, beyond_deg, isKept, onKeep }: Props) {
  // Indices have one scale anyway.
  const hasFixedScale = field.quantity === "index" || field.quantity === "total";
  return (
    <figure class="legend">
      <figcaption>{title}</figcaption>
      <ScaleStrip scale={field.scale} />
      {!hasFixedScale && (
        <label class="tick">
          <input type="checkbox" checked={isKept} onChange={(event) => onKeep(event.currentTarget.checked)} /> Keep this scale when direction or
          input change
        </label>
      )}
      <ul class="swatches">
        <li>
          <Swatch colour={GREY} /> {greyWords(field)}
        </li>
        <li>
          <Swatch colour={BARE} /> On the tire: beyond {fixed(beyond_deg, 0)}° from the contact nothing was computed.
        </li>
      </ul>
    </figure>
  );
}

export function Swatch({ colour }: { colour: Rgb }) {
  return (
    <svg class="swatch" viewBox="0 0 16 12" aria-hidden="true">
      <rect width={16} height={12} fill={css(colour)} />
    </svg>
  );
}

/** What takes the colour away. */
function greyWords({ quantity, noise, errors }: Field): string {
  const unknown = "The noise of films isn't known here: the study scores no layout of films that are read in strain.";
  const film = noise === null ? "" : `${microstrain(noise)} µε`;
  switch (quantity) {
    case "strain":
      return noise === null ? `No value. ${unknown}` : `Strain below the films' noise of ${film}, or no value; full colour from twice that on.`;
    case "std":
      return noise === null ? `No value. ${unknown}` : `Varies by less than the films' noise of ${film}, or no value; full colour from twice that on.`;
    case "signal":
      return "Between the films no signal is computed: each film is a solve of its own. A film is grey, too, where its error exceeds what it reads.";
    case "error":
      return noise === null ? `No value. ${unknown}` : `The strain varies by less than the films' noise of ${film}, or there is no index.`;
    default: {
      const isUnknown = errors.every((error) => error === null);
      const error = isUnknown
        ? "No index. The errors of the indices aren't known at this level, so the colours don't say how far to trust them."
        : "The error exceeds the index, or there is none; full colour where it is half the index or less.";
      return noise === null ? `${error} ${unknown}` : `${error} Grey, too, where the strain varies by less than the films' noise of ${film}.`;
    }
  }
}

export function ScaleStrip({ scale }: { scale: Scale }) {
  const inner = WIDTH - 2 * SIDE;
  const factor = SHOWN_FACTOR[scale.unit];
  return (
    <svg class="scale-strip" viewBox={`0 0 ${WIDTH} 34`} role="img" aria-label={`Colours from ${label(scale, scale.low)} to ${label(scale, scale.high)}`}>
      {Array.from({ length: STRIPES }, (_, index) => (
        <rect
          key={index}
          x={SIDE + (inner * index) / STRIPES}
          width={inner / STRIPES + 0.5}
          height={14}
          fill={css(scale.colour((index + 0.5) / STRIPES))}
          shape-rendering="crispEdges"
        />
      ))}
      <g class="axis">
        {ticks(scale.low * factor, scale.high * factor, 4).map((mark) => {
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
  );
}

function label(scale: Scale, value: number): string {
  if (scale.unit === "volt") return significant(value, 2);
  if (scale.unit === "microstrain") return value === 0 ? "0" : microstrain(value);
  const span = 100 * (scale.high - scale.low);
  return fixed(100 * value, span >= 20 ? 0 : span >= 2 ? 1 : 2);
}
