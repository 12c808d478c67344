/**
 * The wire format of the service under /v1, field by field as it sends it.
 *
 * Strains are plain numbers (not microstrain), angles degrees, times seconds unless a name says otherwise.
 * A number that does not exist is null with a reason beside it.
 */

export type StudyState = "queued" | "running" | "done" | "failed" | "cancelled";
export type Direction = "x" | "y";
export type OutputStatus = "ok" | "constant" | "product-form-broken";

/** A study in the list. */
export interface StudySummary {
  id: string;
  name: string;
  state: StudyState;
  points_total: number;
  points_done: number;
  created: string;
  started: string | null;
  finished: string | null;
  error: string | null;
  /** Whether the service knows what accuracy costs for this study; only an entry asked for by itself says so. */
  trade_measured?: boolean;
  /** The sweep that it is a design of; asked for in the same way. */
  sweep?: string | null;
}

export interface StudyPage {
  studies: StudySummary[];
  next_cursor: string | null;
}

/** A document that ships with the service. */
export interface Preset {
  name: string;
  title: string;
  document: unknown;
  /** What it is for, in a few sentences. */
  comment: string;
}

export interface Presets {
  studies: Preset[];
  scenes: Preset[];
}

/** One thing wrong with a document, at a JSON pointer. */
export interface Fault {
  pointer: string;
  detail: string;
}

/** RFC 9457. */
export interface Problem {
  title: string;
  status: number;
  detail?: string | null;
  errors?: Fault[];
}

export interface Choice {
  what: string;
  why: string;
  effect?: number | null;
}

export interface ModelReport {
  dimension: string;
  level: string;
  elements: number;
  dofs: number;
  modelled: Choice[];
  left_out: Choice[];
}

export interface InputReport {
  name: string;
  vary: string;
  distribution: unknown;
}

/** Parts of the error of a first-order index, absolute. */
export interface IndexError {
  mesh: number | null;
  quadrature: number | null;
  decomposition: number | null;
  total: number | null;
  reason?: string | null;
}

/** Indices of one strain. */
export interface Output {
  location: string;
  direction: Direction;
  mean: number | null;
  std: number | null;
  first_order: number[] | null;
  total: number[] | null;
  method: string;
  status: OutputStatus;
  reason?: string | null;
  mdrm_first_order?: number[] | null;
  error: IndexError;
}

export interface RankedLocation {
  name: string;
  rank: number;
  gsi_x_percent: number | null;
  gsi_y_percent: number | null;
  /** Missing in results of earlier versions. */
  gsi_x_error_percent?: number | null;
  gsi_y_error_percent?: number | null;
  mean_gsi_x_percent: number | null;
  mean_gsi_y_percent: number | null;
  own_gsi_x_percent: number | null;
  own_gsi_y_percent: number | null;
  mdrm_gsi_x_percent: number | null;
  mdrm_gsi_y_percent: number | null;
  rank_x: number | null;
  rank_y: number | null;
  rank_certain: boolean;
}

export interface LayoutScore {
  weakest_signal: number | null;
  worst_angle_error_deg: number | null;
  rms_angle_error_deg: number | null;
  worst_depth_error_mm: number | null;
  noise_strain: number;
  reason?: string | null;
}

export interface RankedLayout {
  rank: number;
  spacing_deg: number;
  units: number;
  position: string;
  films: string[];
  score: LayoutScore;
}

/** One direction of the map; lists are rows by columns, row after row. */
export interface MapLayer {
  direction: Direction;
  strain: number[];
  std: (number | null)[];
  first_order: (number | null)[][];
  error: (number | null)[];
  status: OutputStatus[];
}

export interface IndexMap {
  theta_deg: number[];
  phi_deg: number[];
  layers: MapLayer[];
  /** Where the points lie, mm; missing in results of earlier versions. */
  shape?: { inflated_mm: number[][]; displacement_mm: number[][] } | null;
}

export interface FailedPoint {
  ordinal: number;
  values: number[];
  cause: string;
}

export interface LocationStrain {
  name: string;
  theta_deg: number;
  strain_x: number;
  strain_y: number;
  von_mises_mpa: number;
}

export interface CutPoint {
  values: number[];
  reaction_n: number;
  inflated_outer_radius_mm: number;
  locations: LocationStrain[];
  residual_history: number[][];
}

export interface StudyCost {
  solves: number;
  reused: number;
  newton_iterations: number;
  factorisations: number;
  wall_s: number;
  cpu_s: number;
  peak_memory_bytes: number;
  factorisation_share: number;
  substitution_share: number;
  assembly_share: number;
  other_share: number;
}

/** What a study was expected to take before it started. */
export interface Estimate {
  /** Null where the reasons say why. */
  wall_s: { least: number; expected: number; most: number } | null;
  peak_memory_bytes: number;
  /** Why figures are ranges or null, whole sentences. */
  reasons: string[];
}

/** The whole answer of a study. */
export interface StudyResult {
  study: { id: string; name: string; spec_sha256: string; version: string };
  model: ModelReport;
  inputs: InputReport[];
  outputs: Output[];
  locations: RankedLocation[];
  layouts: RankedLayout[];
  map: IndexMap | null;
  notes: string[];
  failed_points: FailedPoint[];
  cut_point: CutPoint;
  cost: StudyCost;
  /** Missing in results of earlier versions. */
  estimate?: Estimate | null;
}

/** What the stream of a study says, by kind. */
export type StudyEvent =
  | { kind: "queued" }
  | { kind: "started"; points: number; reused: number }
  | { kind: "point-solved"; ordinal: number; done: number; of: number; wall_s: number; newton_iterations: number }
  | { kind: "point-failed"; ordinal: number; done?: number; of?: number; cause: string }
  | { kind: "analysing" }
  | { kind: "done" }
  | { kind: "failed"; error: string; failed_points?: FailedPoint[] }
  | { kind: "cancelled" };

export const EVENT_KINDS: readonly StudyEvent["kind"][] = [
  "queued",
  "started",
  "point-solved",
  "point-failed",
  "analysing",
  "done",
  "failed",
  "cancelled",
];

/** One way to answer a study, and what it gave. Errors are absolute, the largest of the indices that the ranking goes by. */
export interface TradeRung {
  label: string;
  wall_s: number;
  cpu_s: number;
  solves: number;
  error_true: number | null;
  error_claimed: number | null;
  /** Share of the indices whose claimed error covers the true one. */
  covered: number | null;
  ranking_agrees: boolean;
  pareto: boolean;
}

/** The measured trade of accuracy for time. */
export interface Trade {
  study: string;
  spec_sha256: string;
  reference: TradeRung;
  rungs: TradeRung[];
}
