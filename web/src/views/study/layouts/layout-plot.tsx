import { frameOf, upwards } from "../../../lib/chart/frame.ts";
import { log, logTicks } from "../../../lib/chart/scales.ts";
import { errorRange, GUESS_DEG, type LayoutCurve, unitTicks } from "../../../lib/layouts/layout-curves.ts";
import { layoutWords, short } from "../../../lib/layouts/layout-words.ts";
import { Axis } from "../../shared/chart/axis.tsx";
import { Chart } from "../../shared/chart/chart.tsx";
import { KeyEntry, KeyLine } from "../../shared/chart/key.tsx";
import { Curve, type CurveValue } from "../../shared/chart/marks.tsx";

const FRAME = frameOf(900, 400, { left: 52, right: 54, top: 46, bottom: 44 });
/** Outermost curves stand so far from the axes. */
const INDENT = 24;
/** Curves stand this much beside each other, so that their error bars don't hide each other. */
const APART = 2;
/** Units of the paper, 60 degrees apart. */
const PAPERS_UNITS = 6;
/** Width that a number takes. */
const NUMBER = 22;

type Scale = (value: number) => number;

/** The simulated error of the angle over the number of units, both logarithmic; the spacing above. */
export function LayoutPlot({ curves, at }: { curves: LayoutCurve[]; at: string }) {
  const units = curves.flatMap((curve) => curve.points.map((point) => point.units));
  const x = log([Math.min(...units), Math.max(...units)], [FRAME.left + INDENT, FRAME.right - INDENT]);
  const y = log(errorRange(curves), upwards(FRAME)).clamp(true);
  const name = `Simulated 95th percentile of the angle error over the number of units, ${at}, both logarithmic; 60° spacing is marked`;
  const counts = {
    frame: FRAME,
    values: unitTicks(units, PAPERS_UNITS, x, NUMBER),
    at: x,
    tone: (count: number) => (count === PAPERS_UNITS ? "papers" : undefined),
  };
  return (
    <Chart class="layout-plot" frame={FRAME} label={name}>
      <Axis side="left" frame={FRAME} {...logTicks(y, [1, 2, 5])} title="angle error, 95 %, degrees" />
      <Axis side="right" frame={FRAME} values={[GUESS_DEG]} at={y} text={() => "a guess"} class="guess" />
      <Axis side="bottom" {...counts} text={String} title="units around the wheel" />
      <Axis side="top" {...counts} text={(count) => `${short(360 / count)}°`} lines="short" title="spacing of the units" />
      {curves.map((curve, k) => (
        <Drawn
          key={`${curve.position} ${curve.films}`}
          curve={curve}
          kind={kindOf(curve, curves)}
          y={y}
          x={(count) => x(count) + APART * (k - (curves.length - 1) / 2)}
        />
      ))}
    </Chart>
  );
}

/** A curve, with a ring around the paper's layout. */
function Drawn({ curve: { points }, kind, x, y }: { curve: LayoutCurve; kind: string; x: Scale; y: Scale }) {
  const papers = points.find(({ is_papers }) => is_papers);
  const values = points.map(
    ({ layout, units, error_deg, low_deg, high_deg }): CurveValue => ({
      at: [x(units), y(error_deg)],
      ends: [y(low_deg), y(high_deg)],
      title: `${layoutWords(layout)}: ${short(error_deg)}° (${short(low_deg)}° to ${short(high_deg)}°)`,
    }),
  );
  return (
    <>
      <Curve class={kind} values={values} radius={3} />
      {papers !== undefined && <circle class="papers-mark" cx={x(papers.units)} cy={y(papers.error_deg)} r={8} />}
    </>
  );
}

/** A colour for each position, a dash for each set of films. */
function kindOf({ position, films }: LayoutCurve, all: LayoutCurve[]): string {
  return `layout-curve place-${positions(all).indexOf(position) % 6} set-${filmSets(all).indexOf(films) % 6}`;
}

const positions = (all: LayoutCurve[]): string[] => [...new Set(all.map((curve) => curve.position))];
const filmSets = (all: LayoutCurve[]): string[] => [...new Set(all.map((curve) => curve.films))];

/** What colours, dashes and rings mean. */
export function CurveKey({ curves }: { curves: LayoutCurve[] }) {
  return (
    <p class="key">
      {positions(curves).map((position, k) => (
        <KeyLine key={position} class={`layout-curve place-${k % 6}`} text={position.replace(" deg", "°")} length={36} />
      ))}
      {filmSets(curves).map((films, k) => (
        <KeyLine key={films} class={`layout-curve set-${k % 6}`} text={films} length={36} />
      ))}
      {curves.some((curve) => curve.points.some((point) => point.is_papers)) && (
        <KeyEntry text="the paper's layout">
          <circle class="papers-mark" cx={6} cy={6} r={5} />
        </KeyEntry>
      )}
    </p>
  );
}
