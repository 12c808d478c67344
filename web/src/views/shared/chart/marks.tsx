import { linePath, type Point } from "../../../lib/chart/paths.ts";
import type { Ends } from "../../../lib/chart/scales.ts";

interface ErrorBarProps {
  class?: string;
  at: number;
  ends: Ends;
  isLying?: boolean;
  /** Half the length of the strokes at its ends. */
  cap?: number;
}

/** How far a value may be off: upright at an x, or lying at a y. */
export function ErrorBar({ class: kind, at, ends: [from, to], isLying = false, cap = 0 }: ErrorBarProps) {
  const [along, aside] = isLying ? ["H", "V"] : ["V", "H"];
  const point = (place: number, beside: number): string => (isLying ? `${place} ${beside}` : `${beside} ${place}`);
  const strokes = cap === 0 ? "" : [from, to].map((end) => `M${point(end, at - cap)}${aside}${at + cap}`).join("");
  return <path class={kind} d={`M${point(from, at)}${along}${to}${strokes}`} />;
}

/** A value of a curve: where it stands, how far it may be off, and what is said of it. */
export interface CurveValue {
  at: Point;
  ends?: Ends;
  title?: string;
}

/** A line through values, each with a dot and its error. */
export function Curve({ class: kind, values, radius }: { class: string; values: readonly CurveValue[]; radius: number }) {
  return (
    <g class={kind}>
      <path d={linePath(values.map(({ at }) => at))} />
      {values.map(({ at: [x, y], ends, title }) => (
        <g key={x}>
          {ends !== undefined && <ErrorBar class="curve-error" at={x} ends={ends} />}
          <circle cx={x} cy={y} r={radius}>
            {title !== undefined && <title>{title}</title>}
          </circle>
        </g>
      ))}
    </g>
  );
}
