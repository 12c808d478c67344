import { across, frameOf, upwards } from "../../../../lib/chart/frame.ts";
import { linear, linearTicks, type Ends } from "../../../../lib/chart/scales.ts";
import type { Direction } from "../../../../lib/direction.ts";
import { microstrain, significant } from "../../../../lib/format.ts";
import type { SurfacePoint } from "../../../../lib/tire/map/map-grid.ts";
import { strainOver, unitOf } from "../../../../lib/tire/surface/section-lines.ts";
import type { Sections } from "../../../../wire.ts";
import { Axis } from "../../../shared/chart/axis.tsx";
import { Chart } from "../../../shared/chart/chart.tsx";
import { Curve, type CurveValue } from "../../../shared/chart/marks.tsx";

const FRAME = frameOf(320, 190, { left: 62, right: 14, top: 10, bottom: 38 });

const endsOf = (values: readonly number[]): Ends => [Math.min(...values), Math.max(...values)];

/** The strain of the pinned place at each solved value of the input. */
export function DepthPlot({ line, point, direction, value }: { line: Sections; point: SurfacePoint; direction: Direction; value: number | null }) {
  const dots = strainOver(line, point, direction);
  if (dots.length < 2) return <p class="quiet">The pinned place lies beyond the map.</p>;
  const unit = unitOf(line.vary);
  const x = linear(endsOf(dots.map((dot) => dot.value)), across(FRAME));
  const y = linear(endsOf(dots.map((dot) => dot.strain * 1e6)), upwards(FRAME));
  const values = dots.map((dot): CurveValue => ({ at: [x(dot.value), y(dot.strain * 1e6)] }));
  const title = `Strain ${direction} at the pinned place over ${line.input}`;
  const words = dots.map((dot) => `${significant(dot.value)} ${unit} ${microstrain(dot.strain)} µε`).join(", ");
  return (
    <figure class="depth-plot">
      <figcaption>{title}, µε; dots are solves</figcaption>
      <Chart frame={FRAME} label={`${title}: ${words}`}>
        <Axis side="bottom" frame={FRAME} {...linearTicks(x, 4)} lines="none" title={unit === "" ? line.input : `${line.input}, ${unit}`} />
        <Axis side="left" frame={FRAME} {...linearTicks(y, 4)} />
        {value !== null && <line class="slider-line" x1={x(value)} x2={x(value)} y1={FRAME.top} y2={FRAME.bottom} />}
        <Curve class="solves" values={values} radius={3.5} />
      </Chart>
    </figure>
  );
}
