import { useLayoutEffect, useRef, useState } from "preact/hooks";
import { bandPaths, thinned, tickText, timeRange, type BandRun, type Scale } from "../../lib/forces/band-drawing.ts";
import { ticks } from "../../lib/format.ts";
import { Figure } from "../shared/figure.tsx";

const HEIGHT = 190;
const LEFT = 46;
const RIGHT = 8;
const TOP = 8;
const FOOT = 34;
/** Rows for each pixel of the width: more can't be seen. */
const ROWS_PER_PIXEL = 4;

interface Props {
  run: BandRun;
  force: string;
  /** Least and greatest force of all runs, N. */
  range: [number, number];
  /** Name of the estimator, for the files. */
  name: string;
}

const scale = ([low, high]: [number, number], from: number, to: number): Scale => (value) => from + ((to - from) * (value - low)) / (high - low);

/** Truth, estimate and 95 % band of one recording over time. */
export function BandPlot({ run, force, range, name }: Props) {
  const holder = useRef<HTMLDivElement>(null);
  const width = useWidth(holder);
  const times = timeRange(run.rows);
  const [x, y] = [scale(times, LEFT, width - RIGHT), scale(range, HEIGHT - FOOT, TOP)];
  const rows = thinned(run.rows, ROWS_PER_PIXEL * width);
  const paths = bandPaths(rows, x, y);
  const what = paths.truth === "" ? "estimate" : "measured force, estimate";
  return (
    <div ref={holder} class="bands">
      <Figure study={name} name={`${force} ${run.name}`}>
        <figcaption>{run.name}</figcaption>
        <svg width={width} height={HEIGHT} viewBox={`0 0 ${width} ${HEIGHT}`} role="img" aria-label={`${force} of ${run.name} over time: ${what} and 95 % band`}>
          <Axes x={x} y={y} times={times} range={range} width={width} force={force} />
          <path class="band" d={paths.band} />
          <path class="truth-line" d={paths.truth} />
          <path class="estimate-line" d={paths.estimate} />
        </svg>
      </Figure>
    </div>
  );
}

function Axes({ x, y, times, range, width, force }: { x: Scale; y: Scale; times: [number, number]; range: [number, number]; width: number; force: string }) {
  const [right, foot] = [width - RIGHT, HEIGHT - FOOT];
  const heights = ticks(...range, 4);
  const moments = ticks(...times, Math.max(3, Math.round(width / 70)));
  return (
    <g class="axis">
      {heights.map((value) => (
        <g key={value}>
          <line x1={LEFT} x2={right} y1={y(value)} y2={y(value)} />
          <text x={LEFT - 5} y={y(value) + 4} text-anchor="end">
            {tickText(value, stepOf(heights))}
          </text>
        </g>
      ))}
      {moments.map((value) => (
        <text key={value} x={x(value)} y={foot + 14} text-anchor="middle">
          {tickText(value, stepOf(moments))}
        </text>
      ))}
      <text x={LEFT} y={HEIGHT - 4}>
        {force}, N
      </text>
      <text x={right} y={HEIGHT - 4} text-anchor="end">
        time, s
      </text>
    </g>
  );
}

const stepOf = ([first = 0, second = 1]: readonly number[]): number => second - first;

function useWidth(holder: { current: HTMLElement | null }): number {
  const [width, setWidth] = useState(640);
  useLayoutEffect(() => {
    const element = holder.current;
    if (element === null) return undefined;
    const measure = (): void => setWidth(Math.max(240, element.clientWidth));
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  return width;
}

/** What lines and band mean. */
export function BandKey({ hasTruth }: { hasTruth: boolean }) {
  const mark = (kind: string) => (
    <svg viewBox="0 0 24 12" aria-hidden="true">
      {kind === "band" ? <rect class="band" width={24} height={12} /> : <path class={kind} d="M0 6H24" />}
    </svg>
  );
  return (
    <p class="key">
      {hasTruth && <span>{mark("truth-line")}measured</span>}
      <span>{mark("estimate-line")}estimated</span>
      <span>{mark("band")}95 % interval</span>
    </p>
  );
}
