import { errorRange, GUESS_DEG, type LayoutCurve, logTicks, unitTicks } from "../../../lib/layouts/layout-curves.ts";
import { layoutWords, short } from "../../../lib/layouts/layout-words.ts";

const WIDTH = 900;
const HEIGHT = 400;
const LEFT = 52;
const RIGHT = 54;
const TOP = 46;
const FOOT = 44;
/** Curves stand this much beside each other, so that their error bars don't hide each other. */
const APART = 2;
/** Units of the paper, 60 degrees apart. */
const PAPERS_UNITS = 6;
/** Share of the axis that a number takes. */
const TICK = 0.03;

type Scale = (value: number) => number;

const logScale = ([low, high]: [number, number], from: number, to: number): Scale => (value) =>
  from + (to - from) * (high > low ? Math.log(value / low) / Math.log(high / low) : 0.5);

/** The simulated error of the angle over the number of units, both logarithmic; the spacing above. */
export function LayoutPlot({ curves, at }: { curves: LayoutCurve[]; at: string }) {
  const units = curves.flatMap((curve) => curve.points.map((point) => point.units));
  const range = errorRange(curves);
  const x = logScale([Math.min(...units), Math.max(...units)], LEFT + 24, WIDTH - RIGHT - 24);
  const y = logScale(range, HEIGHT - FOOT, TOP);
  const name = `Simulated 95th percentile of the angle error over the number of units, ${at}, both logarithmic; 60° spacing is marked`;
  return (
    <svg class="layout-plot" viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={name}>
      <Axes x={x} y={y} units={unitTicks(curves, TICK)} range={range} />
      {curves.map((curve, k) => (
        <Curve key={`${curve.position} ${curve.films}`} curve={curve} kind={kindOf(curve, curves)} y={y}
          x={(count) => x(count) + APART * (k - (curves.length - 1) / 2)} />
      ))}
    </svg>
  );
}

function Axes({ x, y, units, range }: { x: Scale; y: Scale; units: number[]; range: [number, number] }) {
  const [left, right, foot] = [LEFT, WIDTH - RIGHT, HEIGHT - FOOT];
  return (
    <g class="axis">
      {logTicks(range).map((error) => (
        <g key={error}>
          <line x1={left} x2={right} y1={y(error)} y2={y(error)} />
          <text x={left - 6} y={y(error) + 4} text-anchor="end">
            {error}
          </text>
        </g>
      ))}
      <line class="guess" x1={left} x2={right} y1={y(GUESS_DEG)} y2={y(GUESS_DEG)} />
      <text x={right + 5} y={y(GUESS_DEG) + 4}>
        a guess
      </text>
      {units.map((count) => (
        <g key={count} class={count === PAPERS_UNITS ? "papers" : undefined}>
          <line x1={x(count)} x2={x(count)} y1={TOP - 4} y2={foot} />
          <text x={x(count)} y={foot + 15} text-anchor="middle">
            {count}
          </text>
          <text x={x(count)} y={TOP - 10} text-anchor="middle">
            {short(360 / count)}°
          </text>
        </g>
      ))}
      <text x={(left + right) / 2} y={HEIGHT - 8} text-anchor="middle">
        units around the wheel
      </text>
      <text x={(left + right) / 2} y={13} text-anchor="middle">
        spacing of the units
      </text>
      <text transform={`translate(12 ${(TOP + foot) / 2}) rotate(-90)`} text-anchor="middle">
        angle error, 95 %, degrees
      </text>
    </g>
  );
}

function Curve({ curve, kind, x, y }: { curve: LayoutCurve; kind: string; x: Scale; y: Scale }) {
  const path = curve.points.map((point, k) => `${k === 0 ? "M" : "L"}${x(point.units)} ${y(point.error_deg)}`).join("");
  const lowest = HEIGHT - FOOT;
  return (
    <g class={kind}>
      <path d={path} />
      {curve.points.map(({ layout, units, error_deg, low_deg, high_deg, is_papers }) => (
        <g key={units}>
          <path class="layout-error" d={`M${x(units)} ${low_deg > 0 ? Math.min(y(low_deg), lowest) : lowest}V${y(high_deg)}`} />
          {is_papers && <circle class="papers-mark" cx={x(units)} cy={y(error_deg)} r={8} />}
          <circle cx={x(units)} cy={y(error_deg)} r={3}>
            <title>{`${layoutWords(layout)}: ${short(error_deg)}° (${short(low_deg)}° to ${short(high_deg)}°)`}</title>
          </circle>
        </g>
      ))}
    </g>
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
  const line = (kind: string) => (
    <svg viewBox="0 0 36 12" aria-hidden="true">
      <g class={`layout-curve ${kind}`}>
        <path d="M0 6H36" />
      </g>
    </svg>
  );
  return (
    <p class="key">
      {positions(curves).map((position, k) => (
        <span key={position}>
          {line(`place-${k % 6}`)}
          {position.replace(" deg", "°")}
        </span>
      ))}
      {filmSets(curves).map((films, k) => (
        <span key={films}>
          {line(`set-${k % 6}`)}
          {films}
        </span>
      ))}
      {curves.some((curve) => curve.points.some((point) => point.is_papers)) && (
        <span>
          <svg viewBox="0 0 12 12" aria-hidden="true">
            <circle class="papers-mark" cx={6} cy={6} r={5} />
          </svg>
          the paper's layout
        </span>
      )}
    </p>
  );
}
