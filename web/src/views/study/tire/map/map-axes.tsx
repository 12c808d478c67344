import { fixed, ticks } from "../../../../lib/format.ts";
import { endsOf, type Ruler } from "../../../../lib/tire/map/arc-length.ts";
import { MERIDIONAL_MARKS } from "../../../../lib/tire/map/surface-field.ts";
import { isNarrow, xOf, xOfMark, yOf, yOfMark, type Frame } from "./map-frame.ts";

/** Pixels between two ticks, about. */
const BETWEEN_TICKS = 60;
const FEWEST_TICKS = 6;

function ticksOver(pixels: number): number {
  return Math.max(FEWEST_TICKS, pixels / BETWEEN_TICKS);
}

/** Lengths below and on the left; angles above, and places of the section on the right. */
export function MapAxes({ frame }: { frame: Frame }) {
  const bottom = frame.top + frame.plotHeight;
  const { along, across, unit } = frame.rulers;
  return (
    <g class="axis">
      {unit === "mm" && <Lengths frame={frame} />}
      {ticks(...anglesOf(along), ticksOver(frame.plotWidth)).map((theta) => (
        <g key={theta}>
          <line x1={xOf(frame, theta)} x2={xOf(frame, theta)} y1={frame.top - 4} y2={frame.top} />
          <text x={xOf(frame, theta)} y={frame.top - 8} text-anchor="middle">
            {fixed(theta, 0)}°
          </text>
        </g>
      ))}
      <Places frame={frame} range={anglesOf(across)} />
      <text x={frame.left + frame.plotWidth / 2} y={12} text-anchor="middle">
        θ around the wheel
      </text>
      <text x={frame.left + frame.plotWidth / 2} y={bottom + 36} text-anchor="middle">
        {unit === "mm" ? "mm along the crown, rolling →" : "rolling →"}
      </text>
    </g>
  );
}

function anglesOf({ angles }: Ruler): [number, number] {
  return [angles[0] ?? 0, angles[angles.length - 1] ?? 0];
}

function Lengths({ frame }: { frame: Frame }) {
  const bottom = frame.top + frame.plotHeight;
  const { along, across } = frame.rulers;
  return (
    <g>
      {ticks(...endsOf(along), ticksOver(frame.plotWidth)).map((mark) => (
        <g key={mark}>
          <line x1={xOfMark(frame, mark)} x2={xOfMark(frame, mark)} y1={bottom} y2={bottom + 4} />
          <text x={xOfMark(frame, mark)} y={bottom + 17} text-anchor="middle">
            {fixed(mark, 0)}
          </text>
        </g>
      ))}
      {ticks(...endsOf(across), frame.plotHeight / 36).map((mark) => (
        <g key={mark}>
          <line x1={frame.left - 4} x2={frame.left} y1={yOfMark(frame, mark)} y2={yOfMark(frame, mark)} />
          <text x={frame.left - 8} y={yOfMark(frame, mark) + 4} text-anchor="end">
            {fixed(mark, 0)}
          </text>
        </g>
      ))}
      <text x={4} y={frame.top - 8}>
        mm
      </text>
    </g>
  );
}

/** Bead, sidewall, shoulder and crown. */
function Places({ frame, range }: { frame: Frame; range: [number, number] }) {
  const right = frame.left + frame.plotWidth;
  const shown = MERIDIONAL_MARKS.filter(({ phi_deg }) => phi_deg >= range[0] && phi_deg <= range[1]);
  return (
    <g>
      {shown.map(({ name, phi_deg }) => (
        <g key={phi_deg}>
          <line class="guide" x1={frame.left} x2={right + 4} y1={yOf(frame, phi_deg)} y2={yOf(frame, phi_deg)} />
          <text x={right + 8} y={yOf(frame, phi_deg) + 4}>
            {isNarrow(frame.width) ? name : `${name} ${fixed(phi_deg, 0)}°`}
          </text>
        </g>
      ))}
    </g>
  );
}
