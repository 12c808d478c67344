import { css, type Rgb } from "../../../lib/chart/colour.ts";
import { across, frameOf } from "../../../lib/chart/frame.ts";
import { linear, linearTicks } from "../../../lib/chart/scales.ts";
import { fixed, microstrain, significant } from "../../../lib/format.ts";
import { SHOWN_FACTOR, type Field, type Scale } from "../../../lib/tire/map/surface-field.ts";
import { GREY } from "../../../lib/tire/map/trust.ts";
import { Axis } from "../../shared/chart/axis.tsx";
import { Chart } from "../../shared/chart/chart.tsx";
import { BARE, FILM } from "./wheel/skin-colours.ts";

const STRIP = frameOf(320, 34, { left: 22, right: 22, top: 0, bottom: 20 });
const STRIPES = 120;

interface Props {
  field: Field;
  title: string;
  /** The layout whose films are shown, in words. */
  films?: string | null;
  /** Where the map ends. */
  beyond_deg: number;
  isKept: boolean;
  onKeep: (isKept: boolean) => void;
}

/** The colours of a scale with their values, and what grey means. */
export function TireLegend({ field, title, films = null, beyond_deg, isKept, onKeep }: Props) {
  // Indices have one scale anyway.
  const hasFixedScale = field.quantity === "index" || field.quantity === "total";
  return (
    <figure class="legend">
      <figcaption>{title}</figcaption>
      <ScaleStrip scale={field.scale} />
      {!hasFixedScale && (
        <label class="tick">
          <input type="checkbox" checked={isKept} onChange={(event) => onKeep(event.currentTarget.checked)} /> Keep this scale when direction or input change
        </label>
      )}
      <ul class="swatches">
        <li>
          <Swatch colour={GREY} /> {greyWords(field)}
        </li>
        {films !== null && (
          <li>
            <Swatch colour={FILM} /> {films}.
          </li>
        )}
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
  const factor = SHOWN_FACTOR[scale.unit];
  const x = linear([scale.low * factor, scale.high * factor], across(STRIP));
  const breadth = (STRIP.right - STRIP.left) / STRIPES;
  return (
    <Chart class="scale-strip" frame={STRIP} label={`Colours from ${label(scale, scale.low)} to ${label(scale, scale.high)}`}>
      {Array.from({ length: STRIPES }, (_, index) => (
        <rect
          key={index}
          x={STRIP.left + breadth * index}
          width={breadth + 0.5}
          height={STRIP.bottom}
          fill={css(scale.colour((index + 0.5) / STRIPES))}
          shape-rendering="crispEdges"
        />
      ))}
      <Axis side="bottom" frame={STRIP} {...linearTicks(x, 4)} lines="short" />
    </Chart>
  );
}

function label(scale: Scale, value: number): string {
  if (scale.unit === "volt") return significant(value, 2);
  if (scale.unit === "microstrain") return value === 0 ? "0" : microstrain(value);
  const span = 100 * (scale.high - scale.low);
  return fixed(100 * value, span >= 20 ? 0 : span >= 2 ? 1 : 2);
}
