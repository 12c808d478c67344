/** Picks from a comparison what its tables and charts show. The service computes and judges; nothing here does. */

import type { ComparedLocation, ComparedStudy, Comparison, Verdict } from "../../wire.ts";
import type { Direction } from "../direction.ts";
import type { Shown } from "../route.ts";

/** A design with its places in the order of the columns. */
export interface DesignRow {
  /** Counted from one, in the order of the sweep. */
  number: number;
  study: ComparedStudy;
  cells: (ComparedLocation | null)[];
}

/** Designs by locations. */
export interface Matrix {
  locations: string[];
  /** The designs that have a result. */
  rows: DesignRow[];
  baseline: string | null;
}

export function matrixOf(comparison: Comparison): Matrix {
  const locations = [...new Set(comparison.rows.map((row) => row.location))];
  locations.sort((a, b) => a.localeCompare(b, "en", { numeric: true }));
  const column = new Map(locations.map((name, index) => [name, index]));
  const cells = new Map<string, (ComparedLocation | null)[]>();
  for (const row of comparison.rows) {
    const ofStudy = cells.get(row.study) ?? locations.map(() => null);
    ofStudy[column.get(row.location) ?? 0] = row;
    cells.set(row.study, ofStudy);
  }
  const rows = comparison.studies.flatMap((study, index) => {
    const ofStudy = cells.get(study.id);
    return ofStudy === undefined ? [] : [{ number: index + 1, study, cells: ofStudy }];
  });
  return { locations, rows, baseline: comparison.baseline ?? null };
}

/** A design in the chart of one location. */
export interface DesignMark {
  number: number;
  name: string;
  /** Percent, or percentage points of a difference. */
  value: number;
  error: number | null;
  /** Null in the baseline. */
  verdict: Verdict | null;
}

/** One location over the designs; those without a figure are left out. */
export interface Strip {
  location: string;
  marks: DesignMark[];
  /** What the vertical axis reaches from and to. */
  low: number;
  high: number;
  /** The baseline's figure. */
  reference: number | null;
}

/** The charts of a direction. One percentage point is as high in each of them. */
export function strips(matrix: Matrix, direction: Direction, shown: Shown): Strip[] {
  const drawn = matrix.locations.map((location, column) => {
    const marks = matrix.rows.flatMap((row) => markOf(row, column, direction, shown, matrix.baseline));
    const base = matrix.rows.find((row) => row.study.id === matrix.baseline);
    const reference = marks.find((mark) => mark.number === base?.number)?.value ?? null;
    return { location, marks, reference, reach: reachOf(marks) };
  });
  const half = Math.max(LEAST_SPAN, ...drawn.map(({ reach }) => reach[1] - reach[0])) * 0.54;
  return drawn.map(({ location, marks, reference, reach }) => {
    const middle = (reach[0] + reach[1]) / 2;
    return { location, marks, reference, low: middle - half, high: middle + half };
  });
}

/** Percentage points that an axis spans at least, so that rounding doesn't look like a difference. */
const LEAST_SPAN = 1;

function markOf(row: DesignRow, column: number, direction: Direction, shown: Shown, baseline: string | null): DesignMark[] {
  const cell = row.cells[column];
  if (cell == null) return [];
  const index = cell[direction];
  const common = { number: row.number, name: row.study.name, verdict: index.verdict ?? null };
  if (shown === "index") {
    return index.gsi_percent == null ? [] : [{ ...common, value: index.gsi_percent, error: index.error_percent ?? null }];
  }
  if (row.study.id === baseline) return [{ ...common, value: 0, error: null }];
  if (index.difference_percent == null) return [];
  return [{ ...common, value: index.difference_percent, error: index.difference_error_percent ?? null }];
}

function reachOf(marks: readonly DesignMark[]): [number, number] {
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (const { value, error } of marks) {
    low = Math.min(low, value - (error ?? 0));
    high = Math.max(high, value + (error ?? 0));
  }
  return marks.length === 0 ? [0, 0] : [low, high];
}

/** How many differences of a direction are real, and of how many. */
export function realDifferences(matrix: Matrix, direction: Direction): { real: number; of: number } {
  const verdicts = matrix.rows.flatMap((row) => row.cells.flatMap((cell) => (cell === null ? [] : (cell[direction].verdict ?? []))));
  return { real: verdicts.filter((verdict) => verdict === "real").length, of: verdicts.length };
}

/** A text below each design of the chart, its axis' title, and every how many of them there is room for. */
export interface DesignAxis {
  title: string;
  labels: string[];
  every: number;
}

/** Designs that all have room for a text. */
const FEW = 10;
const LONGEST_LABEL = 6;

/** What a single varied path sets where that is short, numbers otherwise. */
export function designAxis(designs: readonly { set: Record<string, unknown> }[]): DesignAxis {
  const paths = new Set(designs.flatMap(({ set }) => Object.keys(set)));
  const [path] = paths;
  if (paths.size === 1 && path !== undefined && designs.length <= FEW) {
    const labels = designs.map(({ set }) => String(set[path] ?? ""));
    if (labels.every((label) => label !== "" && label.length <= LONGEST_LABEL)) return { title: path, labels, every: 1 };
  }
  const labels = designs.map((_, index) => String(index + 1));
  const every = designs.length <= FEW ? 1 : designs.length <= 4 * FEW ? 2 : 5;
  return { title: "design, by its number in the table", labels, every };
}
