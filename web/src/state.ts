/** The one state of the page. Views are functions of it; actions alone change it. */

import { textOf } from "./lib/draft.ts";
import type { Progress } from "./lib/progress.ts";
import { parseRoute, type Route } from "./lib/route.ts";
import type { Presets, Problem, StudyResult, StudySummary, Trade } from "./types.ts";

/** Something that is asked for: not here yet, here, or refused. */
export type Loadable<T> =
  | { status: "loading" }
  | { status: "ready"; value: T }
  | { status: "failed"; problem: Problem };

export interface StudyList {
  studies: StudySummary[];
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

export interface AppState {
  route: Route;
  /** The page's clock, milliseconds since the epoch. */
  now_ms: number;
  list: Loadable<StudyList>;
  presets: Loadable<Presets>;
  draft: Draft;
  open: OpenStudy | null;
}

export function initialState(hash: string, now_ms: number): AppState {
  return {
    route: parseRoute(hash),
    now_ms,
    list: { status: "loading" },
    presets: { status: "loading" },
    draft: emptyDraft(),
    open: null,
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

/** The newer entries take the place of the older ones; what only the older list has stays behind them. */
export function mergeLists(older: StudyList, newer: StudyList): StudyList {
  const known = new Set(newer.studies.map((study) => study.id));
  const rest = older.studies.filter((study) => !known.has(study.id));
  const cursor = rest.length > 0 ? older.next_cursor : newer.next_cursor;
  return { studies: [...newer.studies, ...rest], next_cursor: cursor };
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
