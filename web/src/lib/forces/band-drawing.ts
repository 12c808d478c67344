/** Truth, estimate and 95 % band over time, as lines to be drawn. */

import { fixed } from "../format.ts";
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

export type Scale = (value: number) => number;

/** The paths of an SVG. */
export interface BandPaths {
  band: string;
  truth: string;
  estimate: string;
}

export function bandPaths(rows: readonly BandRow[], x: Scale, y: Scale): BandPaths {
  const parts = stretches(rows);
  const line = (of: (row: BandRow) => number | null): string => parts.map((part) => pathOf(part, x, y, of)).join("");
  const band = parts.map((part) => {
    const there = points(part, x, y, (row) => row.high_n);
    const back = points([...part].reverse(), x, y, (row) => row.low_n);
    return `M${[...there, ...back].join("L")}Z`;
  });
  return { band: band.join(""), truth: line((row) => row.truth_n), estimate: line((row) => row.estimate_n) };
}

function pathOf(rows: readonly BandRow[], x: Scale, y: Scale, of: (row: BandRow) => number | null): string {
  const there = points(rows, x, y, of);
  return there.length < 2 ? "" : `M${there.join("L")}`;
}

function points(rows: readonly BandRow[], x: Scale, y: Scale, of: (row: BandRow) => number | null): string[] {
  return rows.flatMap((row) => {
    const value = of(row);
    return value === null ? [] : [`${short(x(row.time_s))} ${short(y(value))}`];
  });
}

const short = (value: number): string => String(Math.round(10 * value) / 10);

/** From the least to the greatest of all that is drawn, with a little room; the same for all runs, so that heights compare. */
export function forceRange(runs: readonly BandRun[]): [number, number] {
  let [low, high] = [0, 0];
  for (const { rows } of runs) {
    for (const row of rows) {
      low = Math.min(low, row.low_n, row.truth_n ?? row.low_n);
      high = Math.max(high, row.high_n, row.truth_n ?? row.high_n);
    }
  }
  if (!(high > low)) return [low - 1, high + 1];
  const beside = BESIDE * (high - low);
  return [low - beside, high + beside];
}

/** Share of the height that is left free above and below. */
const BESIDE = 0.04;

/** A round number of an axis whose steps are so long, without decimals that say nothing. */
export function tickText(value: number, step: number): string {
  return fixed(value, Math.max(0, -Math.floor(Math.log10(step) + 1e-9)));
}

export function timeRange(rows: readonly BandRow[]): [number, number] {
  const [first, last] = [rows[0]?.time_s ?? 0, rows.at(-1)?.time_s ?? 1];
  return last > first ? [first, last] : [first, first + 1];
}
