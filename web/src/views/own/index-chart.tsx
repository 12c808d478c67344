import { useRef } from "preact/hooks";
import { across, frameOf } from "../../lib/chart/frame.ts";
import { linearTicks, percents, places, placeTicks } from "../../lib/chart/scales.ts";
import { fixed, MISSING } from "../../lib/format.ts";
import type { IndexBar } from "../../lib/own/own-analysis.ts";
import { Axis } from "../shared/chart/axis.tsx";
import { Chart } from "../shared/chart/chart.tsx";
import { ErrorBar } from "../shared/chart/marks.tsx";
import { useWidth } from "../shared/chart/use-width.ts";
import { Figure } from "../shared/picture/figure.tsx";

/** A narrower place scrolls. */
const [LEAST_WIDTH, MOST_WIDTH, ROW] = [300, 620, 30];
const BESIDE = { left: 130, right: 110, top: 8, bottom: 36 };
/** Share of a row that is free. */
const GAP = 7 / 15;
/** Characters of a name that fit beside the bars. */
const LONGEST = 18;

/** First-order indices of an output as bars, each with its error. */
export function IndexChart({ output, bars, model }: { output: string; bars: readonly IndexBar[]; model: string }) {
  const holder = useRef<HTMLDivElement>(null);
  const width = Math.min(MOST_WIDTH, Math.max(LEAST_WIDTH, useWidth(holder, MOST_WIDTH)));
  const frame = frameOf(width, BESIDE.top + ROW * bars.length + BESIDE.bottom, BESIDE);
  const x = percents(across(frame));
  const y = places(
    bars.map(({ name }) => name),
    [frame.top, frame.bottom],
    GAP,
  );
  const rows = placeTicks(y);
  const words = bars.map((bar) => `${bar.name} ${figure(bar)}`).join(", ");
  return (
    <div ref={holder}>
      <Figure study={model} name={`indices-${output}`}>
        <Chart frame={frame} isFixed label={`First-order indices of ${output}, percent: ${words}`}>
          <Axis side="bottom" frame={frame} {...linearTicks(x, 4)} title="% of the variance" />
          <Axis class="bar-names" side="left" frame={frame} {...rows} text={short} lines="none" />
          {bars.map((bar) => (
            <g key={bar.name} transform={`translate(0 ${rows.at(bar.name)})`}>
              <rect class="bar" x={x(0)} y={-y.bandwidth() / 2} width={x(bar.percent) - x(0)} height={y.bandwidth()} />
              {bar.error !== null && <ErrorBar class="error-bar" isLying at={0} ends={[x(bar.percent - bar.error), x(bar.percent + bar.error)]} cap={5} />}
              <text class="bar-value" x={width - 4} y={4} text-anchor="end">
                {figure(bar)}
              </text>
            </g>
          ))}
        </Chart>
      </Figure>
    </div>
  );
}

function figure({ percent, error }: IndexBar): string {
  return `${fixed(percent, 1)} ± ${error === null ? MISSING : fixed(error, 1)}`;
}

function short(name: string): string {
  return name.length > LONGEST ? `${name.slice(0, LONGEST - 1)}…` : name;
}
