/** Truth, estimate and 95 % band over time, as lines to be drawn. */

import { closedPath, linePath, type Point } from "../chart/paths.ts";
import { type Ends, padded } from "../chart/scales.ts";
import type { LeftOutRows } from "../../wire.ts";

export interface BandRow {
  time_s: number;
  /** Null where it wasn't measured. */
  truth_n: number | null;
  estimate_n: number;
  low_n: number;
  high_n: number;
}

/** The rows of one recording. */
export interface BandRun {
  name: string;
  rows: BandRow[];
}

/** A longer time between rows than so many usual ones is a pause, over which no line is drawn. */
const PAUSE = 10;

/** The rows that were left out, by their recordings, in the order of time. */
export function bandRuns(left: LeftOutRows, files: readonly string[]): BandRun[] {
  const runs = new Map<number, BandRow[]>();
  left.run.forEach((run, k) => {
    const rows = runs.get(run) ?? [];
    runs.set(run, rows);
    const [time_s, truth_n, estimate_n, low_n, high_n] = [left.time_s[k], left.truth_n[k], left.estimate_n[k], left.low_n[k], left.high_n[k]];
    if (time_s === undefined || truth_n === undefined || estimate_n === undefined || low_n === undefined || high_n === undefined) return;
    rows.push({ time_s, truth_n, estimate_n, low_n, high_n });
  });
  const inOrder = [...runs].sort(([a], [b]) => a - b);
  return inOrder.map(([run, rows]) => ({ name: files[run] ?? `recording ${run + 1}`, rows: [...rows].sort((a, b) => a.time_s - b.time_s) }));
}

/** At most so many rows: of each stretch those with the least and the greatest truth, so that no peak is lost. */
export function thinned(rows: readonly BandRow[], most: number): readonly BandRow[] {
  if (rows.length <= most) return rows;
  const stretch = Math.ceil((2 * rows.length) / most);
  const kept: BandRow[] = [];
  for (let from = 0; from < rows.length; from += stretch) {
    const part = rows.slice(from, from + stretch);
    const height = (row: BandRow): number => row.truth_n ?? row.estimate_n;
    const least = part.reduce((a, b) => (height(b) < height(a) ? b : a));
    const greatest = part.reduce((a, b) => (height(b) > height(a) ? b : a));
    kept.push(...new Set([least, greatest].sort((a, b) => a.time_s - b.time_s)));
  }
  return kept;
}

/** Stretches without a pause. */
export function stretches(rows: readonly BandRow[]): BandRow[][] {
  const steps = rows.slice(1).map((row, k) => row.time_s - (rows[k]?.time_s ?? row.time_s));
  const usual = [...steps].sort((a, b) => a - b)[Math.floor(steps.length / 2)] ?? 0;
  const parts: BandRow[][] = [];
  rows.forEach((row, k) => {
    const last = parts.at(-1);
    if (last === undefined || (k > 0 && (steps[k - 1] ?? 0) > PAUSE * usual)) parts.push([row]);
    else last.push(row);
  });
  return parts;
}

type Scale = (value: number) => number;

/** The paths of an SVG. */
interface BandPaths {
  band: string;
  truth: string;
  estimate: string;
}

export function bandPaths(rows: readonly BandRow[], x: Scale, y: Scale): BandPaths {
  const parts = stretches(rows);
  const points = (part: readonly BandRow[], of: (row: BandRow) => number | null): Point[] =>
    part.flatMap((row) => {
      const value = of(row);
      return value === null ? [] : [[x(row.time_s), y(value)]];
    });
  const line = (of: (row: BandRow) => number | null): string => parts.map((part) => linePath(points(part, of))).join("");
  const band = parts.map((part) => closedPath([...points(part, (row) => row.high_n), ...points(part, (row) => row.low_n).reverse()]));
  return { band: band.join(""), truth: line((row) => row.truth_n), estimate: line((row) => row.estimate_n) };
}

/** From the least to the greatest of all that is drawn, nothing among it; the same for all runs, so that heights compare. */
export function forceRange(runs: readonly BandRun[]): Ends {
  let [low, high] = [0, 0];
  for (const { rows } of runs) {
    for (const { low_n, high_n, truth_n } of rows) {
      low = Math.min(low, low_n, truth_n ?? low_n);
      high = Math.max(high, high_n, truth_n ?? high_n);
    }
  }
  return padded([low, high]);
}

export function timeRange(rows: readonly BandRow[]): Ends {
  return [rows[0]?.time_s ?? 0, rows.at(-1)?.time_s ?? 1];
}
