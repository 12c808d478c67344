import { across, frameOf } from "../../../../lib/chart/frame.ts";
import { linearTicks, percents, places, placeTicks } from "../../../../lib/chart/scales.ts";
import { fixed } from "../../../../lib/format.ts";
import type { InputShare } from "../../../../wire.ts";
import { Axis } from "../../../shared/chart/axis.tsx";
import { Chart } from "../../../shared/chart/chart.tsx";
import { ErrorBar } from "../../../shared/chart/marks.tsx";
import { Figure } from "../../../shared/picture/figure.tsx";

const [WIDTH, ROW] = [460, 24];
const BESIDE = { left: 150, right: 96, top: 8, bottom: 36 };
/** Share of a row that is free. */
const GAP = 7 / 15;
/** Bars that are drawn; the rest are smaller. */
const MOST = 12;

/** Shares of inputs in a quantity's variance, the greatest first. */
export function ShareBars({ study, title, shares }: { study: string; title: string; shares: readonly InputShare[] }) {
  const rows = shares.slice(0, MOST).map(({ input, index, error }) => ({ input, percent: 100 * index, error: error == null ? null : 100 * error }));
  const frame = frameOf(WIDTH, BESIDE.top + ROW * rows.length + BESIDE.bottom, BESIDE);
  const x = percents(across(frame));
  const y = places(
    rows.map(({ input }) => input),
    [frame.top, frame.bottom],
    GAP,
  );
  const words = rows.map(({ input, percent }) => `${input} ${fixed(percent, 1)}`).join(", ");
  return (
    <Figure study={study} name={`inputs-${title.toLowerCase().replace(/[^a-z0-9]+/g, "-")}`}>
      <figcaption>{title}</figcaption>
      <Chart frame={frame} label={`${title}, percent of the variance: ${words}`}>
        <Axis side="bottom" frame={frame} {...linearTicks(x, 4)} title="percent of the variance" />
        <Axis class="bar-names" side="left" frame={frame} {...placeTicks(y)} lines="none" />
        {rows.map(({ input, percent, error }) => (
          <g key={input} transform={`translate(0 ${placeTicks(y).at(input)})`}>
            <rect class="bar" x={x(0)} y={-y.bandwidth() / 2} width={x(Math.max(0, percent)) - x(0)} height={y.bandwidth()} />
            {error !== null && <ErrorBar class="error-bar" isLying at={0} ends={[x(percent - error), x(percent + error)]} cap={5} />}
            <text class="bar-value" x={WIDTH - 4} y={4} text-anchor="end">
              {fixed(percent, 1)}
              {error === null ? "" : ` ± ${fixed(error, 1)}`}
            </text>
          </g>
        ))}
      </Chart>
    </Figure>
  );
}
