import { linear, linearTicks } from "../../../../lib/chart/scales.ts";
import { fixed } from "../../../../lib/format.ts";
import { MERIDIONAL_MARKS } from "../../../../lib/tire/map/surface-field.ts";
import { Axis } from "../../../shared/chart/axis.tsx";
import { isNarrow, xOf, yOf, type MapFrame } from "./map-frame.ts";

/** Pixels between two ticks, about. */
const [APART_ALONG, APART_ACROSS] = [80, 50];
const FEWEST_TICKS = 4;

/** Lengths below and on the left; angles above, and places of the section on the right. */
export function MapAxes({ frame }: { frame: MapFrame }) {
  const { along, unit } = frame.rulers;
  const few = Math.max(FEWEST_TICKS, (frame.right - frame.left) / APART_ALONG);
  const isLong = unit === "mm";
  const lengths = linearTicks(frame.x, few);
  const angles = linear([along.angles[0] ?? 0, along.angles.at(-1) ?? 0], [0, 1]).ticks(few);
  return (
    <g>
      <Axis
        side="bottom"
        frame={frame}
        {...lengths}
        values={isLong ? lengths.values : []}
        lines="short"
        title={isLong ? "mm along the crown, rolling →" : "rolling →"}
      />
      {isLong && (
        <Axis side="left" frame={frame} {...linearTicks(frame.y, (frame.bottom - frame.top) / APART_ACROSS)} lines="short" title="mm" titlePlace="end" />
      )}
      <Axis
        side="top"
        frame={frame}
        values={angles}
        at={(theta) => xOf(frame, theta)}
        text={(theta) => `${fixed(theta, 0)}°`}
        lines="short"
        title="θ around the wheel"
      />
      <Places frame={frame} />
    </g>
  );
}

/** Bead, sidewall, shoulder and crown. */
function Places({ frame }: { frame: MapFrame }) {
  const { angles } = frame.rulers.across;
  const [low, high] = [angles[0] ?? 0, angles.at(-1) ?? 0];
  const shown = MERIDIONAL_MARKS.filter(({ phi_deg }) => phi_deg >= low && phi_deg <= high);
  const name = (phi: number): string => shown.find(({ phi_deg }) => phi_deg === phi)?.name ?? "";
  return (
    <Axis
      class="guides"
      side="right"
      frame={frame}
      values={shown.map(({ phi_deg }) => phi_deg)}
      at={(phi) => yOf(frame, phi)}
      text={(phi) => (isNarrow(frame.width) ? name(phi) : `${name(phi)} ${fixed(phi, 0)}°`)}
    />
  );
}
