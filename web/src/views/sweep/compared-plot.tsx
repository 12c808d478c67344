import { useRef } from "preact/hooks";
import { frameOf, upwards, type Frame } from "../../lib/chart/frame.ts";
import { log, logTicks } from "../../lib/chart/scales.ts";
import { errorsOf } from "../../lib/layouts/film-trade.ts";
import { unitTicks } from "../../lib/layouts/layout-curves.ts";
import { comparedTrades } from "../../lib/sweep/compared-trades.ts";
import type { ComparedStudy } from "../../wire.ts";
import { Axis } from "../shared/chart/axis.tsx";
import { Chart } from "../shared/chart/chart.tsx";
import { KeyLine } from "../shared/chart/key.tsx";
import { Curve } from "../shared/chart/marks.tsx";
import { useWidth } from "../shared/chart/use-width.ts";
import { Figure } from "../shared/picture/figure.tsx";

const [LEAST_WIDTH, MOST_WIDTH, HEIGHT] = [300, 1000, 280];
const MARGIN = { left: 52, right: 14, top: 10, bottom: 40 };
/** Outermost points stand so far from the axes. */
const INDENT = 18;
/** Width that a number takes. */
const NUMBER = 22;

/** The error of the angle over the number of films, a curve for each study, both logarithmic; layouts that are compared have rings. */
export function ComparedPlot({ studies }: { studies: readonly ComparedStudy[] }) {
  const holder = useRef<HTMLDivElement>(null);
  const width = Math.min(MOST_WIDTH, Math.max(LEAST_WIDTH, useWidth(holder, MOST_WIDTH)));
  return <div ref={holder}>{drawnOn(frameOf(width, HEIGHT, MARGIN), studies)}</div>;
}

function drawnOn(frame: Frame, studies: readonly ComparedStudy[]) {
  const drawn = comparedTrades(studies).filter(({ trade }) => trade.points.length > 1);
  if (drawn.length === 0) return null;
  const points = drawn.flatMap(({ trade }) => trade.points);
  const counts = points.map(({ row }) => row.film_count);
  const ranges = drawn.map(({ trade }) => errorsOf(trade));
  const x = log([Math.min(...counts), Math.max(...counts)], [frame.left + INDENT, frame.right - INDENT]);
  const y = log([Math.min(...ranges.map(([low]) => low)), Math.max(...ranges.map(([, high]) => high))], upwards(frame)).clamp(true);
  const picked = points.filter(({ is_picked }) => is_picked);
  const others = drawn.filter(({ isColoured }) => !isColoured).length;
  return (
    <Figure class="compared-trades" study="comparison" name="films against error">
      <Chart
        frame={frame}
        isFixed
        label={`Films against the error of the angle for ${drawn.length} studies, best first: ${drawn.map(({ name }) => name).join(", ")}`}
      >
        <Axis side="left" frame={frame} {...logTicks(y, [1, 2, 5])} title="angle error, °" />
        <Axis side="bottom" frame={frame} values={unitTicks(counts, picked[0]?.row.film_count ?? 0, x, NUMBER)} at={x} text={String} title="films" />
        {[...drawn].reverse().map(({ id, name, kind, trade }) => (
          <Curve
            key={id}
            class={kind}
            radius={3}
            values={trade.points.map(({ row, error, low, high, title }) => ({
              at: [x(row.film_count), y(error)],
              ends: [y(low), y(high)],
              title: `${name}: ${title}`,
            }))}
          />
        ))}
        {picked.map(({ row, error }) => (
          <circle key={`${row.film_count} ${error}`} class="picked-mark" cx={x(row.film_count)} cy={y(error)} r={8} />
        ))}
      </Chart>
      <p class="key">
        {drawn
          .filter(({ isColoured }) => isColoured)
          .map(({ id, name, kind }) => (
            <KeyLine key={id} class={kind} text={name} />
          ))}
        {others > 0 && <KeyLine class="layout-curve others" text={`${others} others`} />}
      </p>
    </Figure>
  );
}
