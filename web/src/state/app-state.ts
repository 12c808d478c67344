/** The one state of the page. Views are functions of it; actions alone change it. */

import { textOf } from "../lib/document/draft.ts";
import type { Progress } from "../lib/study/point-progress.ts";
import { parseRoute, type Route } from "../lib/route.ts";
import type { Comparison, SweepDetail, SweepEstimate, SweepSummary } from "../sweep-types.ts";
import type { Presets, Problem, StudyResult, StudySummary, Trade } from "../types.ts";

/** Something that is asked for: not here yet, here, or refused. */
export type Loadable<T> =
  | { status: "loading" }
  | { status: "ready"; value: T }
  | { status: "failed"; problem: Problem };

export interface StudyList {
  studies: StudySummary[];
  next_cursor: string | null;
}

export interface SweepList {
  sweeps: SweepSummary[];
  next_cursor: string | null;
}

/** The document being written. */
export interface Draft {
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
  summary: Loadable<StudySummary>;
  progress: Progress | null;
  link: Link;
  /** Null until the study is done. */
  result: Loadable<StudyResult> | null;
  /** What accuracy costs; null where nobody has measured it. */
  trade: Trade | null;
  cancelProblem: Problem | null;
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
  list: Loadable<StudyList>;
  sweeps: Loadable<SweepList>;
  presets: Loadable<Presets>;
  draft: Draft;
  sweepDraft: SweepDraft;
  open: OpenStudy | null;
  openSweep: OpenSweep | null;
}

export function initialState(hash: string, now_ms: number): AppState {
  return {
    route: parseRoute(hash),
    now_ms,
    list: { status: "loading" },
    sweeps: { status: "loading" },
    presets: { status: "loading" },
    draft: emptyDraft(),
    sweepDraft: { name: "", grid: "", busy: null, problem: null, estimated: null },
    open: null,
    openSweep: null,
  };
}

export function emptyDraft(): Draft {
  return { preset: null, text: "", sending: false, problem: null, idempotencyKey: newKey() };
}

export function draftOf(preset: string, document: unknown): Draft {
  return { ...emptyDraft(), preset, text: textOf(document) };
}

export function openStudy(id: string): OpenStudy {
  return {
    id,
    summary: { status: "loading" },
    progress: null,
    link: "connecting",
    result: null,
    trade: null,
    cancelProblem: null,
  };
}

export function openSweep(id: string): OpenSweep {
  return { id, detail: { status: "loading" }, lost: false, comparison: null, problem: null };
}

/** The newer entries take the place of the older ones; what only the older list has stays behind them. */
export function mergeLists(older: StudyList, newer: StudyList): StudyList {
  const studies = merged(older.studies, newer.studies);
  const next_cursor = studies.length > newer.studies.length ? older.next_cursor : newer.next_cursor;
  return { studies, next_cursor };
}

/** The same for sweeps. */
export function mergeSweeps(older: SweepList, newer: SweepList): SweepList {
  const sweeps = merged(older.sweeps, newer.sweeps);
  const next_cursor = sweeps.length > newer.sweeps.length ? older.next_cursor : newer.next_cursor;
  return { sweeps, next_cursor };
}

function merged<T extends { id: string }>(older: T[], newer: T[]): T[] {
  const known = new Set(newer.map((entry) => entry.id));
  return [...newer, ...older.filter((entry) => !known.has(entry.id))];
}

/** 128 random bits in hex; `crypto.randomUUID` is missing on plain http beyond localhost. */
export function newKey(): string {
  const values = crypto.getRandomValues(new Uint8Array(16));
  return [...values].map((value) => value.toString(16).padStart(2, "0")).join("");
}

/** A state that tells its listeners of every change. */
export interface Store {
  get(): AppState;
  update(change: (state: AppState) => AppState): void;
  subscribe(listener: () => void): () => void;
}

export function createStore(initial: AppState): Store {
  let state = initial;
  const listeners = new Set<() => void>();
  return {
    get: () => state,
    update: (change) => {
      const next = change(state);
      if (next === state) return;
      state = next;
      listeners.forEach((listener) => listener());
    },
    subscribe: (listener) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
