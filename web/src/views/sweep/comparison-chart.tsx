import { directionName, type Direction } from "../../lib/direction.ts";
import { fixed, MISSING, signed, ticks } from "../../lib/format.ts";
import type { Shown } from "../../lib/route.ts";
import { strips, type DesignAxis, type DesignMark, type Matrix, type Strip } from "../../lib/sweep/comparison-matrix.ts";

const STRIP = 84;
const GAP = 14;
const TOP = 6;
const FOOT = 34;
const AXIS = 58;
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
  const drawn = strips(matrix, direction, shown);
  const bottom = TOP + (STRIP + GAP) * drawn.length;
  const what = shown === "index" ? "First-order indices" : "Differences from the baseline";
  const name = `${what} of ${axis.labels.length} designs, strain ${directionName(direction)}; the table below has the figures`;
  return (
    <figure class="comparison-chart">
      <figcaption>Strain {directionName(direction)}, {shown === "index" ? "percent" : "percentage points"}</figcaption>
      <div class="chart-body">
        <svg width={AXIS} height={bottom + FOOT} aria-hidden="true">
          {drawn.map((strip, index) => (
            <Scale key={strip.location} strip={strip} top={topOf(index)} shown={shown} />
          ))}
        </svg>
        <div class="chart-scroll" tabIndex={0} role="region" aria-label={`Designs, strain ${direction}`}>
          <svg width="100%" height={bottom + FOOT} style={{ minWidth: `${COLUMN * axis.labels.length}px` }} role="img" aria-label={name}>
            {drawn.map((strip, index) => (
              <Marks key={strip.location} strip={strip} top={topOf(index)} designs={axis.labels.length} shown={shown} />
            ))}
            <Designs axis={axis} bottom={bottom} />
          </svg>
        </div>
      </div>
    </figure>
  );
}

const topOf = (index: number): number => TOP + (STRIP + GAP) * index;

const heightOf = (strip: Strip, top: number, value: number): number =>
  top + (STRIP * (strip.high - value)) / (strip.high - strip.low);

const percent = (share: number): string => `${100 * share}%`;

const marksOf = (strip: Strip): number[] => ticks(strip.low, strip.high, 4);

function Scale({ strip, top, shown }: { strip: Strip; top: number; shown: Shown }) {
  const values = marksOf(strip);
  const decimals = values.every(Number.isInteger) ? 0 : 1;
  return (
    <g class="axis">
      <text class="bar-name" x={0} y={top + STRIP / 2 + 4}>
        {strip.location}
      </text>
      {values.map((value) => (
        <text key={value} x={AXIS - 6} y={heightOf(strip, top, value) + 4} text-anchor="end">
          {shown === "index" || value === 0 ? fixed(value, decimals) : signed(value, decimals)}
        </text>
      ))}
    </g>
  );
}

function Marks({ strip, top, designs, shown }: { strip: Strip; top: number; designs: number; shown: Shown }) {
  const { reference } = strip;
  return (
    <g>
      <rect class="strip" x="0" y={top} width="100%" height={STRIP} />
      <g class="axis">
        {marksOf(strip).map((value) => (
          <line key={value} x1="0" x2="100%" y1={heightOf(strip, top, value)} y2={heightOf(strip, top, value)} />
        ))}
      </g>
      {reference !== null && (
        <line class="reference" x1="0" x2="100%" y1={heightOf(strip, top, reference)} y2={heightOf(strip, top, reference)} />
      )}
      {strip.marks.map((mark) => (
        <svg key={mark.number} x={percent((mark.number - 0.5) / designs)} y={heightOf(strip, top, mark.value)} overflow="visible">
          <title>{`${mark.number}: ${mark.name}, ${strip.location}: ${figure(mark, shown)}`}</title>
          <ErrorBar reach={((mark.error ?? 0) * STRIP) / (strip.high - strip.low)} tone={toneOf(mark)} />
          <Symbol tone={toneOf(mark)} />
        </svg>
      ))}
    </g>
  );
}

type Tone = "baseline" | "real" | "noise" | "unknown";

const toneOf = (mark: DesignMark): Tone => mark.verdict ?? "baseline";

function figure(mark: DesignMark, shown: Shown): string {
  const text = shown === "index" ? fixed(mark.value, 2) : signed(mark.value, 2);
  const error = mark.error === null ? MISSING : fixed(mark.error, 2);
  return mark.verdict === null ? `${text} ± ${error}, the baseline` : `${text} ± ${error}, ${mark.verdict}`;
}

function ErrorBar({ reach, tone }: { reach: number; tone: Tone }) {
  if (reach === 0) return null;
  return <path class={`reach reach-${tone}`} d={`M0 ${-reach}V${reach}M-3 ${-reach}H3M-3 ${reach}H3`} />;
}

/** Told apart by shape as well as by colour. */
function Symbol({ tone }: { tone: Tone }) {
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

function Designs({ axis, bottom }: { axis: DesignAxis; bottom: number }) {
  const count = axis.labels.length;
  return (
    <g class="axis">
      {axis.labels.map((label, index) =>
        index % axis.every === 0 ? (
          <text key={label} x={percent((index + 0.5) / count)} y={bottom + 8} text-anchor="middle">
            {label}
          </text>
        ) : null,
      )}
      <text x="0" y={bottom + 26}>
        {axis.title}
      </text>
    </g>
  );
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
        <span key={tone}>
          <svg viewBox="-7 -7 14 14" aria-hidden="true">
            <Symbol tone={tone} />
          </svg>
          {text}
        </span>
      ))}
      <span>
        {shown === "index"
          ? "Bars are the errors of the indices; those of a difference are smaller where both err alike."
          : "Bars are the errors of the differences."}
      </span>
    </p>
  );
}
