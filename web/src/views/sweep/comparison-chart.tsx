import { linear, linearTicks, places, placeTicks, type Ends, type Linear } from "../../lib/chart/scales.ts";
import { directionName, type Direction } from "../../lib/direction.ts";
import { fixed, MISSING, signed } from "../../lib/format.ts";
import type { Shown } from "../../lib/route.ts";
import { strips, type DesignAxis, type DesignMark, type Matrix, type Strip } from "../../lib/sweep/comparison-matrix.ts";
import { Axis } from "../shared/chart/axis.tsx";
import { ErrorBar } from "../shared/chart/marks.tsx";
import { KeyEntry } from "../shared/chart/key.tsx";

const [STRIP, GAP, TOP, FOOT, AXIS] = [84, 14, 6, 40, 58];
/** Numbers beside a strip, about. */
const MARKS = 3;
/** Least width of a design; what doesn't fit is scrolled to. */
const COLUMN = 14;

interface Props {
  matrix: Matrix;
  axis: DesignAxis;
  direction: Direction;
  shown: Shown;
}

/** One strip for each location, the designs side by side in it. Widths are shares, so that text stays as large in any window. */
export function ComparisonChart({ matrix, axis, direction, shown }: Props) {
  const drawn = strips(matrix, direction, shown).map((strip, index) => ({ strip, y: scaleOf(strip, TOP + (STRIP + GAP) * index) }));
  const bottom = TOP + (STRIP + GAP) * drawn.length - GAP;
  const what = shown === "index" ? "First-order indices" : "Differences from the baseline";
  const name = `${what} of ${axis.labels.length} designs, strain ${directionName(direction)}; the table below has the figures`;
  const across = designPlaces(axis);
  return (
    <figure class="comparison-chart">
      <figcaption>
        Strain {directionName(direction)}, {shown === "index" ? "percent" : "percentage points"}
      </figcaption>
      <div class="chart-body">
        <svg width={AXIS} height={bottom + FOOT} aria-hidden="true">
          {drawn.map(({ strip, y }) => (
            <StripAxis key={strip.location} name={strip.location} y={y} shown={shown} />
          ))}
        </svg>
        <div class="chart-scroll" tabIndex={0} role="region" aria-label={`Designs, strain ${direction}`}>
          <svg width="100%" height={bottom + FOOT} style={{ minWidth: `${COLUMN * axis.labels.length}px` }} role="img" aria-label={name}>
            {drawn.map(({ strip, y }) => (
              <Marks key={strip.location} strip={strip} x={across.at} y={y} shown={shown} />
            ))}
            <Axis side="bottom" frame={{ ...WHOLE, bottom, height: bottom + FOOT }} {...across} lines="none" title={axis.title} titlePlace="start" />
          </svg>
        </div>
      </div>
    </figure>
  );
}

const WHOLE = { width: AXIS, left: 0, right: "100%", top: 0 };

const scaleOf = ({ low, high }: Strip, top: number): Linear => linear([low, high], [top + STRIP, top]);

/** Designs by their numbers, where they stand as shares, and what is written below them. */
function designPlaces({ labels, every }: DesignAxis) {
  const ticks = placeTicks(
    places(
      labels.map((_, index) => index + 1),
      [0, 100],
    ),
  );
  const values = ticks.values.filter((_, index) => index % every === 0);
  return { values, at: (design: number) => `${ticks.at(design)}%`, text: (design: number) => labels[design - 1] ?? "" };
}

function StripAxis({ name, y, shown }: { name: string; y: Linear; shown: Shown }) {
  const [bottom = 0, top = 0] = y.range();
  const ticks = linearTicks(y, MARKS);
  const text = (value: number): string => (shown === "difference" && value > 0 ? `+${ticks.text(value)}` : ticks.text(value));
  return (
    <g>
      <Axis side="left" frame={{ width: AXIS, height: bottom, left: AXIS, right: AXIS, top, bottom }} {...ticks} text={text} lines="none" />
      <text class="strip-name" x={0} y={(top + bottom) / 2 + 4}>
        {name}
      </text>
    </g>
  );
}

function Marks({ strip, x, y, shown }: { strip: Strip; x: (design: number) => string; y: Linear; shown: Shown }) {
  const { reference } = strip;
  const [bottom = 0, top = 0] = y.range();
  return (
    <g>
      <rect class="strip" x="0" y={top} width="100%" height={STRIP} />
      <Axis side="left" frame={{ ...WHOLE, top, bottom, height: bottom }} {...linearTicks(y, MARKS)} text={null} />
      {reference !== null && <line class="reference" x1="0" x2="100%" y1={y(reference)} y2={y(reference)} />}
      {strip.marks.map((mark) => (
        <svg key={mark.number} x={x(mark.number)} y={y(mark.value)} overflow="visible">
          <title>{`${mark.number}: ${mark.name}, ${strip.location}: ${figure(mark, shown)}`}</title>
          {(mark.error ?? 0) !== 0 && <ErrorBar class={`reach reach-${toneOf(mark)}`} at={0} ends={reachOf(y, mark)} cap={3} />}
          <MarkShape tone={toneOf(mark)} />
        </svg>
      ))}
    </g>
  );
}

/** Ends of its error bar, seen from the mark. */
function reachOf(y: Linear, { error }: DesignMark): Ends {
  const reach = y(error ?? 0) - y(0);
  return [reach, -reach];
}

type Tone = "baseline" | "real" | "noise" | "unknown";

const toneOf = (mark: DesignMark): Tone => mark.verdict ?? "baseline";

function figure(mark: DesignMark, shown: Shown): string {
  const text = shown === "index" ? fixed(mark.value, 2) : signed(mark.value, 2);
  const error = mark.error === null ? MISSING : fixed(mark.error, 2);
  return mark.verdict === null ? `${text} ± ${error}, the baseline` : `${text} ± ${error}, ${mark.verdict}`;
}

/** Told apart by shape as well as by colour. */
function MarkShape({ tone }: { tone: Tone }) {
  switch (tone) {
    case "baseline":
      return <rect class="mark-baseline" x={-4} y={-4} width={8} height={8} />;
    case "real":
      return <path class="mark-real" d="M0 -6L5 0L0 6L-5 0Z" />;
    case "noise":
      return <circle class="mark-noise" r={3.5} />;
    case "unknown":
      return <path class="mark-unknown" d="M-4 -4L4 4M-4 4L4 -4" />;
  }
}

const KEYS: readonly { tone: Tone; text: string }[] = [
  { tone: "baseline", text: "baseline" },
  { tone: "real", text: "real difference from it" },
  { tone: "noise", text: "noise: within the difference's error" },
  { tone: "unknown", text: "error not known" },
];

/** What the marks mean. */
export function MarkKey({ shown }: { shown: Shown }) {
  return (
    <p class="key">
      {KEYS.map(({ tone, text }) => (
        <KeyEntry key={tone} text={text} box="-7 -7 14 14">
          <MarkShape tone={tone} />
        </KeyEntry>
      ))}
      <span>
        {shown === "index"
          ? "Bars are the errors of the indices; those of a difference are smaller where both err alike."
          : "Bars are the errors of the differences."}
      </span>
    </p>
  );
}
