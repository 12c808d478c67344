/** Picks from a result what a view shows. The service computes and ranks; nothing here does. */

import type { Output, RankedLayout, RankedLocation, StudyResult } from "../../wire.ts";
import type { Direction } from "../direction.ts";
import { paperPercent } from "./paper/paper-table.ts";

/** One bar: an index in percent with what stands beside it. */
export interface Bar {
  name: string;
  /** First-order index, percent; null when it doesn't exist. */
  percent: number | null;
  /** Error of the index, percentage points. */
  error: number | null;
  /** What M-DRM's product form gives, valid or not, percent. */
  mdrm: number | null;
}

/** Locations of the outputs, in the order of the document. */
export function locationNames(result: StudyResult): string[] {
  return [...new Set(result.outputs.map((output) => output.location))];
}

/** The deformation centre: the middle location. */
export function centreName(result: StudyResult): string | null {
  const names = locationNames(result);
  return names[Math.floor(names.length / 2)] ?? null;
}

function outputOf(result: StudyResult, location: string | null, direction: Direction): Output | null {
  return result.outputs.find((output) => output.location === location && output.direction === direction) ?? null;
}

/** The strain at the deformation centre, by which locations are ranked. */
export function centreOutput(result: StudyResult, direction: Direction): Output | null {
  return outputOf(result, centreName(result), direction);
}

/** Locations in the order of the service's ranks. */
export function byRank(result: StudyResult): RankedLocation[] {
  return [...result.locations].sort((a, b) => a.rank - b.rank);
}

/** The layout that the answer names; null where it names none. */
export function answersLayout({ answer, layouts }: StudyResult): RankedLayout | null {
  return layouts.find(({ rank }) => rank === answer?.layout?.rank) ?? null;
}

/** Scores of a location, in percent, each with a figure for either direction. */
export type Score = "gsi" | "mean_gsi" | "own_gsi" | "mdrm_gsi";

/** One figure of a location; null when it doesn't exist. */
export function scoreOf(location: RankedLocation, score: Score, direction: Direction): number | null {
  return location[`${score}_${direction}_percent`] ?? null;
}

/** Whether any location has a figure to be ranked by: its own depth varies. */
export function isRanked(result: StudyResult): boolean {
  return result.locations.some((location) => location.input != null);
}

/** Bars of one direction, best location first. */
export function bars(result: StudyResult, direction: Direction): Bar[] {
  return byRank(result).map((location) => ({
    name: location.name,
    percent: scoreOf(location, "gsi", direction),
    error: location[`gsi_${direction}_error_percent`] ?? null,
    mdrm: scoreOf(location, "mdrm_gsi", direction),
  }));
}

/** Whether M-DRM's product form is broken for the centre's strain in this direction. */
export function productFormBroken(result: StudyResult, direction: Direction): boolean {
  return centreOutput(result, direction)?.status === "product-form-broken";
}

/** The row with the largest value of a column, which is set in bold; null without values. */
export function largest<T>(rows: readonly T[], value: (row: T) => number | null): T | null {
  return rows.reduce<T | null>((best, row) => {
    const [candidate, record] = [value(row), best === null ? null : value(best)];
    return candidate !== null && (record === null || candidate > record) ? row : best;
  }, null);
}

/** How far two columns lie from the paper's, largest difference over the locations, percentage points. */
interface PaperGap {
  mdrm: number;
  valid: number;
}

/** Compares M-DRM's column and the valid one with the paper's; null when a figure is missing. */
export function paperGap(result: StudyResult, direction: Direction): PaperGap | null {
  const gap: PaperGap = { mdrm: 0, valid: 0 };
  for (const bar of bars(result, direction)) {
    const paper = paperPercent(bar.name, direction);
    if (paper === null || bar.mdrm === null || bar.percent === null) return null;
    gap.mdrm = Math.max(gap.mdrm, Math.abs(bar.mdrm - paper));
    gap.valid = Math.max(gap.valid, Math.abs(bar.percent - paper));
  }
  return gap;
}

/** Largest difference between M-DRM's column and the valid one, percentage points, and whether the error covers it. */
export function mdrmGap(result: StudyResult, direction: Direction): { points: number; covered: boolean } | null {
  const rows = bars(result, direction);
  const gaps = rows.map((bar) => (bar.mdrm === null || bar.percent === null ? null : Math.abs(bar.mdrm - bar.percent)));
  if (gaps.length === 0 || gaps.some((gap) => gap === null)) return null;
  const points = Math.max(...(gaps as number[]));
  const error = rows[0]?.error ?? null;
  return { points, covered: error !== null && points <= error };
}
