import { useRef } from "preact/hooks";
import { across, frameOf, upwards } from "../../lib/chart/frame.ts";
import { linear, linearTicks, type Ends } from "../../lib/chart/scales.ts";
import { bandPaths, thinned, timeRange, type BandRun } from "../../lib/forces/band-drawing.ts";
import { Axis } from "../shared/chart/axis.tsx";
import { Chart } from "../shared/chart/chart.tsx";
import { KeyEntry, KeyLine } from "../shared/chart/key.tsx";
import { Figure } from "../shared/picture/figure.tsx";
import { useWidth } from "../shared/chart/use-width.ts";

const [LEAST_WIDTH, GUESSED_WIDTH, HEIGHT] = [240, 640, 190];
const BESIDE = { left: 46, right: 8, top: 8, bottom: 34 };
/** Rows for each pixel of the width: more can't be seen. */
const ROWS_PER_PIXEL = 4;

interface Props {
  run: BandRun;
  force: string;
  /** Least and greatest force of all runs, N. */
  range: Ends;
  /** Name of the estimator, for the files. */
  name: string;
}

/** Truth, estimate and 95 % band of one recording over time. */
export function BandPlot({ run, force, range, name }: Props) {
  const holder = useRef<HTMLDivElement>(null);
  const width = Math.max(LEAST_WIDTH, useWidth(holder, GUESSED_WIDTH));
  const frame = frameOf(width, HEIGHT, BESIDE);
  const [x, y] = [linear(timeRange(run.rows), across(frame)), linear(range, upwards(frame))];
  const paths = bandPaths(thinned(run.rows, ROWS_PER_PIXEL * width), x, y);
  const what = paths.truth === "" ? "estimate" : "measured force, estimate";
  return (
    <div ref={holder} class="bands">
      <Figure study={name} name={`${force} ${run.name}`}>
        <figcaption>{run.name}</figcaption>
        <Chart frame={frame} isFixed label={`${force} of ${run.name} over time: ${what} and 95 % band`}>
          <Axis side="left" frame={frame} {...linearTicks(y, 4)} title={`${force}, N`} titlePlace="start" />
          <Axis side="bottom" frame={frame} {...linearTicks(x, Math.max(3, Math.round(width / 70)))} lines="none" title="time, s" />
          <path class="band" d={paths.band} />
          <path class="truth-line" d={paths.truth} />
          <path class="estimate-line" d={paths.estimate} />
        </Chart>
      </Figure>
    </div>
  );
}

/** What lines and band mean. */
export function BandKey({ hasTruth }: { hasTruth: boolean }) {
  return (
    <p class="key">
      {hasTruth && <KeyLine class="truth-line" text="measured" />}
      <KeyLine class="estimate-line" text="estimated" />
      <KeyEntry text="95 % interval" box="0 0 24 12">
        <rect class="band" width={24} height={12} />
      </KeyEntry>
    </p>
  );
}
