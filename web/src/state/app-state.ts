/** The one state of the page. Views are functions of it; actions alone change it. */

import type { Problem, Wanted } from "../api.ts";
import { textOf } from "../lib/document/draft-text.ts";
import type { TypedToml } from "../lib/document/toml/toml-text.ts";
import type { RecordingFile } from "../lib/forces/recording-files.ts";
import type { Page } from "../lib/shell/pages.ts";
import { parseRoute, type Route } from "../lib/route.ts";
import type { Progress } from "../lib/study/point-progress.ts";
import type {
  AwaySweep,
  Comparison,
  Estimate,
  EstimatorDetail,
  EstimatorSummary,
  LeftOutRows,
  Look,
  Presets,
  Preview,
  Report,
  StudyDetail,
  StudyResult,
  StudySummary,
  SweepDetail,
  SweepEstimate,
  SweepSummary,
  Trade,
} from "../wire.ts";
import type { Loadable } from "./loadable.ts";

/** The document that a draft began with. */
export interface Origin {
  name: string;
  document: unknown;
  /** The study that has it; null for a preset. */
  study: string | null;
  /** The films of a layout that was moved by hand and is added to it, as an address has them. */
  films: string | null;
}

export type FormTab = "form" | "text" | "toml";

/** The study document being written. Its text is the one source: the form's fields write into it. */
export interface StudyDraft {
  preset: string | null;
  /** Null until something was chosen. */
  origin: Origin | null;
  tab: FormTab;
  text: string;
  /** What was typed as TOML last; null before anything was. */
  toml: TypedToml | null;
  sending: boolean;
  problem: Problem | null;
  /** Renewed with every edit. */
  idempotencyKey: string;
}

/** What the service says of a draft while it is written. */
export interface DraftCheck {
  /** The draft that was asked about last. */
  text: string;
  asking: boolean;
  /** Null while nothing of the draft is known. */
  estimate: Estimate | null;
  problem: Problem | null;
}

/** A draft solved on the coarsest mesh while it is written. */
export interface StudyPreview {
  /** Whether the service has previews; null until it was asked. */
  isOffered: boolean | null;
  asking: boolean;
  /** The newest answer, and the draft that it is of. */
  shown: { text: string; preview: Preview } | null;
  /** The first answer since the draft began, which the others are compared with. */
  start: { origin: Origin | null; preview: Preview } | null;
  problem: Problem | null;
}

/** How the page hears of a running study. */
export type Link = "connecting" | "live" | "polling" | "closed";

/** The study in view. */
export interface OpenStudy {
  id: string;
  detail: Loadable<StudyDetail>;
  progress: Progress | null;
  link: Link;
  /** Since when the service doesn't answer, milliseconds since the epoch; null while it does. */
  lost_ms: number | null;
  /** Without its map; null until the study is done. */
  result: Loadable<StudyResult> | null;
  /** With its map; null until a section needs that. */
  whole: Loadable<StudyResult> | null;
  /** What accuracy costs; null where nobody has measured it. */
  trade: Trade | null;
  /** Why it couldn't be cancelled. */
  problem: Problem | null;
}

/** What a sweep of the document being written varies. */
export interface SweepDraft {
  /** The document's name when empty. */
  name: string;
  grid: string;
  /** Whose machines solve it; the service's own when null. */
  engine: string | null;
  busy: "estimating" | "sending" | null;
  problem: Problem | null;
  /** Of the document and the grid as they were then. */
  estimated: EstimatedSweep | null;
}

interface EstimatedSweep {
  estimate: SweepEstimate;
  /** Names of the engines that could solve it. */
  engines: string[];
  /** Text of the study, to see whether it is still the one. */
  text: string;
  document: unknown;
  idempotencyKey: string;
}

/** The sweep in view. */
export interface OpenSweep {
  id: string;
  detail: Loadable<SweepDetail>;
  /** The service was asked again and didn't answer. */
  lost: boolean;
  /** Null until a design has a result. */
  comparison: Loadable<Comparison> | null;
  /** What other machines do for it; null where none were asked. */
  away: Away | null;
  /** Why it couldn't be cancelled or resumed. */
  problem: Problem | null;
}

/** A sweep that an engine has or had. */
export interface Away extends AwaySweep {
  engine: string;
}

/** An entry that has just left its list. */
export interface Moved {
  kind: "studies" | "sweeps";
  id: string;
  name: string;
  /** A removed one is gone for good once its message is closed or the page is left. */
  to: "archive" | "list" | "nowhere";
}

/** What its reader looks for and has ticked in the lists. */
export interface Browsing {
  /** As it is typed. */
  search: string;
  /** What the lists were asked for last. */
  wanted: Wanted;
  /** Those that can be taken back, the newest last: all that were removed, and the newest of the others. */
  moved: readonly Moved[];
  /** Studies to compare, in the order in which they were ticked. */
  ticked: string[];
  /** Documents of studies that share their name with others. */
  documents: ReadonlyMap<string, unknown>;
}

/** Studies side by side. */
export interface OpenComparison {
  /** Their identifiers and the baseline's, as the address has them. */
  id: string;
  details: Loadable<StudyDetail[]>;
  comparison: Loadable<Comparison>;
}

/** What forces are to be learnt from. */
export interface ForcesDraft {
  /** The first recording's file when empty. */
  name: string;
  /** TOML or JSON; all defaults when empty. */
  recipe: string;
  files: RecordingFile[];
  sending: boolean;
  problem: Problem | null;
  /** What their columns are taken for; null until somebody asks, and after every edit. */
  look: Loadable<Look> | null;
  /** Renewed with every edit. */
  idempotencyKey: string;
}

/** The estimator in view. */
export interface OpenEstimator {
  id: string;
  detail: Loadable<EstimatorDetail>;
  /** The service was asked again and didn't answer. */
  lost: boolean;
  /** Null until it is done. */
  report: Loadable<Report> | null;
  leftOut: Loadable<LeftOutRows[]> | null;
  /** Why it couldn't be cancelled or removed. */
  problem: Problem | null;
}

export interface AppState {
  route: Route;
  /** The page's clock, milliseconds since the epoch. */
  now_ms: number;
  studies: Loadable<Page<StudySummary>>;
  sweeps: Loadable<Page<SweepSummary>>;
  presets: Loadable<Presets>;
  browsing: Browsing;
  studyDraft: StudyDraft;
  draftCheck: DraftCheck;
  preview: StudyPreview;
  sweepDraft: SweepDraft;
  openStudy: OpenStudy | null;
  openSweep: OpenSweep | null;
  openComparison: OpenComparison | null;
  estimators: Loadable<Page<EstimatorSummary>>;
  forcesDraft: ForcesDraft;
  openEstimator: OpenEstimator | null;
}

export function initialState(hash: string, now_ms: number): AppState {
  return {
    route: parseRoute(hash),
    now_ms,
    studies: { status: "loading" },
    sweeps: { status: "loading" },
    presets: { status: "loading" },
    browsing: { search: "", wanted: { search: "", archived: false }, moved: [], ticked: [], documents: new Map() },
    studyDraft: emptyDraft(),
    draftCheck: { text: "", asking: false, estimate: null, problem: null },
    preview: { isOffered: null, asking: false, shown: null, start: null, problem: null },
    sweepDraft: { name: "", grid: "", engine: null, busy: null, problem: null, estimated: null },
    openStudy: null,
    openSweep: null,
    openComparison: null,
    estimators: { status: "loading" },
    forcesDraft: emptyForcesDraft(),
    openEstimator: null,
  };
}

function emptyDraft(): StudyDraft {
  return { preset: null, origin: null, tab: "form", text: "", toml: null, sending: false, problem: null, idempotencyKey: newKey() };
}

/** Nothing to learn from yet. */
export function emptyForcesDraft(): ForcesDraft {
  return { name: "", recipe: "", files: [], sending: false, problem: null, look: null, idempotencyKey: newKey() };
}

/** A new draft of this document; the reader's choice of form or text stays. */
export function draftOf(origin: Origin, preset: string | null, tab: FormTab): StudyDraft {
  return { ...emptyDraft(), preset, origin, tab, text: textOf(origin.document) };
}

export function openedStudy(id: string): OpenStudy {
  return { id, detail: { status: "loading" }, progress: null, link: "connecting", lost_ms: null, result: null, whole: null, trade: null, problem: null };
}

export function openedSweep(id: string): OpenSweep {
  return { id, detail: { status: "loading" }, lost: false, comparison: null, away: null, problem: null };
}

export function openedComparison(id: string): OpenComparison {
  return { id, details: { status: "loading" }, comparison: { status: "loading" } };
}

export function openedEstimator(id: string): OpenEstimator {
  return { id, detail: { status: "loading" }, lost: false, report: null, leftOut: null, problem: null };
}

/** 128 random bits in hex; `crypto.randomUUID` is missing on plain http beyond localhost. */
export function newKey(): string {
  const values = crypto.getRandomValues(new Uint8Array(16));
  return [...values].map((value) => value.toString(16).padStart(2, "0")).join("");
}
