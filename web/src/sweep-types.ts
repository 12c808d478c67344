/** The wire format of sweeps and comparisons under /v1, field by field as the service sends it. */

import type { StudyState, StudySummary } from "./types.ts";

/** Designs by where they stand. */
export type DesignCounts = Record<StudyState, number>;

/** A sweep in the list. */
export interface SweepSummary {
  id: string;
  name: string;
  state: StudyState;
  counts: DesignCounts;
  /** Null until the plans of all designs are known. */
  points_total: number | null;
  points_done: number;
  created: string;
  finished: string | null;
}

export interface SweepPage {
  sweeps: SweepSummary[];
  next_cursor: string | null;
}

/** What a design sets, by path. */
export type Settings = Record<string, unknown>;

export interface DesignView {
  ordinal: number;
  name: string;
  set: Settings;
  study: StudySummary;
}

export interface SweepDetail extends SweepSummary {
  document: unknown;
  designs: DesignView[];
}

/** Whether a difference is beyond its error; unknown where there is no error. */
export type Verdict = "real" | "noise" | "unknown";

/** An index beside the baseline's, percent and percentage points. */
export interface ComparedIndex {
  gsi_percent: number | null;
  error_percent: number | null;
  difference_percent: number | null;
  difference_error_percent: number | null;
  verdict: Verdict | null;
}

/** A location in one of the studies. */
export interface ComparedLocation {
  study: string;
  location: string;
  rank: number;
  rank_certain: boolean;
  /** Places lost since the baseline, negative when gained. */
  rank_change: number | null;
  rank_verdict: Verdict | null;
  x: ComparedIndex;
  y: ComparedIndex;
}

/** One of the studies. */
export interface ComparedStudy {
  id: string;
  name: string;
  state: StudyState;
  /** Why there is no result. */
  reason: string | null;
  level: string | null;
  reaction_n: number | null;
  std_strain_x: number | null;
  std_strain_y: number | null;
  best: string | null;
  best_certain: boolean | null;
  layout_spacing_deg: number | null;
  layout_position: string | null;
  cost: ComparedCost | null;
}

/** What a design took; the result has more. */
export interface ComparedCost {
  solves: number;
  coarser_solves: number;
  effect_solves: number;
  reused: number;
  wall_s: number;
}

export interface Comparison {
  /** Null when none of the studies has a result. */
  baseline: string | null;
  studies: ComparedStudy[];
  /** Every location of every study that has a result, best first. */
  rows: ComparedLocation[];
  notes: string[];
}

/** A number before it is known. */
export interface Range {
  least: number;
  expected: number;
  most: number;
}

/** What a sweep would cost. */
export interface SweepEstimate {
  designs: { name: string; estimate: { reasons: string[] } }[];
  left: Range;
  /** Null where a design's reasons say why. */
  wall_s: Range | null;
  peak_memory_bytes: number;
}
