/** The one state of the page. Views are functions of it; actions alone change it. */

import type { Problem } from "../api.ts";
import { textOf } from "../lib/document/draft-text.ts";
import type { Page } from "../lib/pages.ts";
import { parseRoute, type Route } from "../lib/route.ts";
import type { Progress } from "../lib/study/point-progress.ts";
import type { Comparison, Presets, StudyDetail, StudyResult, StudySummary, SweepDetail, SweepEstimate, SweepSummary, Trade } from "../wire.ts";
import type { Loadable } from "./loadable.ts";

/** The study document being written. */
export interface StudyDraft {
  preset: string | null;
  text: string;
  sending: boolean;
  problem: Problem | null;
  /** Renewed with every edit. */
  idempotencyKey: string;
}

/** How the page hears of a running study. */
export type Link = "connecting" | "live" | "polling" | "closed";

/** The study in view. */
export interface OpenStudy {
  id: string;
  detail: Loadable<StudyDetail>;
  progress: Progress | null;
  link: Link;
  /** Null until the study is done. */
  result: Loadable<StudyResult> | null;
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
  busy: "estimating" | "sending" | null;
  problem: Problem | null;
  /** Of the document and the grid as they were then. */
  estimated: EstimatedSweep | null;
}

export interface EstimatedSweep {
  estimate: SweepEstimate;
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
  /** Why it couldn't be cancelled or resumed. */
  problem: Problem | null;
}

export interface AppState {
  route: Route;
  /** The page's clock, milliseconds since the epoch. */
  now_ms: number;
  studies: Loadable<Page<StudySummary>>;
  sweeps: Loadable<Page<SweepSummary>>;
  presets: Loadable<Presets>;
  studyDraft: StudyDraft;
  sweepDraft: SweepDraft;
  openStudy: OpenStudy | null;
  openSweep: OpenSweep | null;
}

export function initialState(hash: string, now_ms: number): AppState {
  return {
    route: parseRoute(hash),
    now_ms,
    studies: { status: "loading" },
    sweeps: { status: "loading" },
    presets: { status: "loading" },
    studyDraft: emptyDraft(),
    sweepDraft: { name: "", grid: "", busy: null, problem: null, estimated: null },
    openStudy: null,
    openSweep: null,
  };
}

function emptyDraft(): StudyDraft {
  return { preset: null, text: "", sending: false, problem: null, idempotencyKey: newKey() };
}

export function draftOf(preset: string, document: unknown): StudyDraft {
  return { ...emptyDraft(), preset, text: textOf(document) };
}

export function openedStudy(id: string): OpenStudy {
  return { id, detail: { status: "loading" }, progress: null, link: "connecting", result: null, trade: null, problem: null };
}

export function openedSweep(id: string): OpenSweep {
  return { id, detail: { status: "loading" }, lost: false, comparison: null, problem: null };
}

/** 128 random bits in hex; `crypto.randomUUID` is missing on plain http beyond localhost. */
export function newKey(): string {
  const values = crypto.getRandomValues(new Uint8Array(16));
  return [...values].map((value) => value.toString(16).padStart(2, "0")).join("");
}
