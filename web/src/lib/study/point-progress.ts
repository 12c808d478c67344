import type { FailedPoint, LiveSolve, State, StudySummary } from "../../wire.ts";
import type { StudyEvent } from "./stream-events.ts";

/** How far a study is, from the list entry and the events of its stream. Pure: time comes in as a number. */

/** One failed point as the stream told it; its inputs come with the end of the study. */
export interface PointFailure {
  ordinal: number;
  cause: string;
  values: readonly number[];
}

export interface Progress {
  state: State;
  /** Null until the plan is known. */
  total: number | null;
  done: number;
  /** Points taken from the archive; null until the stream tells. */
  reused: number | null;
  /** Newton iterations by the ordinal of the point, so that an event told twice counts once. */
  newton: ReadonlyMap<number, number>;
  /** Wall seconds of solved points by ordinal. */
  wall_s: ReadonlyMap<number, number>;
  failures: readonly PointFailure[];
  /** Solves under way, as far as they are told of. */
  solves: readonly LiveSolve[];
  /** Every point has its outcome and the indices are being computed. */
  analysing: boolean;
  /** Milliseconds since the epoch. */
  started_ms: number | null;
  finished_ms: number | null;
  error: string | null;
}

/** What the list entry alone tells. */
export function fromSummary(summary: StudySummary): Progress {
  return {
    state: summary.state,
    total: summary.points_total ?? null,
    done: summary.points_done,
    reused: null,
    newton: new Map(),
    wall_s: new Map(),
    failures: [],
    solves: [],
    analysing: false,
    started_ms: milliseconds(summary.started),
    finished_ms: milliseconds(summary.finished),
    error: summary.error ?? null,
  };
}

/** Takes a newer list entry over, keeping what only the stream tells. */
export function withSummary(progress: Progress, summary: StudySummary): Progress {
  const fresh = fromSummary(summary);
  return {
    ...progress,
    state: isOver(progress.state) ? progress.state : fresh.state,
    total: fresh.total === null ? progress.total : Math.max(fresh.total, progress.total ?? 0),
    done: Math.max(progress.done, fresh.done),
    started_ms: fresh.started_ms ?? progress.started_ms,
    finished_ms: fresh.finished_ms ?? progress.finished_ms,
    error: fresh.error ?? progress.error,
  };
}

/** The progress after one event; events may come twice and late. */
export function advance(progress: Progress, event: StudyEvent, now_ms: number): Progress {
  if (isOver(progress.state)) return { ...progress, failures: failuresOf(progress.failures, event) };
  switch (event.kind) {
    case "queued":
      return progress;
    case "started":
      return {
        ...progress,
        state: "running",
        total: event.points,
        reused: event.reused,
        done: Math.max(progress.done, event.reused),
        started_ms: progress.started_ms ?? now_ms,
      };
    case "solving":
      return { ...progress, solves: event.solves };
    case "point-solved":
      return {
        ...progress,
        solves: without(progress.solves, event.ordinal),
        state: "running",
        total: event.of,
        done: Math.max(progress.done, event.done),
        newton: new Map(progress.newton).set(event.ordinal, event.newton_iterations),
        wall_s: new Map(progress.wall_s).set(event.ordinal, event.wall_s),
        started_ms: progress.started_ms ?? now_ms,
      };
    case "point-failed":
      return {
        ...progress,
        solves: without(progress.solves, event.ordinal),
        total: event.of,
        done: Math.max(progress.done, event.done),
        failures: failuresOf(progress.failures, event),
      };
    case "analysing":
      return { ...progress, solves: [], analysing: true };
    case "failed":
      return {
        ...progress,
        state: "failed",
        error: event.error,
        failures: failuresOf(progress.failures, event),
        finished_ms: now_ms,
      };
    case "done":
    case "cancelled":
      return { ...progress, state: event.kind, finished_ms: now_ms };
  }
}

export function isOver(state: State): boolean {
  return state === "done" || state === "failed" || state === "cancelled";
}

/** Share of the points that are done, 0 to 1. */
export function share({ total, done }: Pick<Progress, "total" | "done">): number {
  return total === null || total <= 0 ? 0 : Math.min(1, done / total);
}

export function elapsedSeconds(progress: Progress, now_ms: number): number | null {
  if (progress.started_ms === null) return null;
  return Math.max(0, ((progress.finished_ms ?? now_ms) - progress.started_ms) / 1000);
}

/** Seconds left at the pace so far; null before a point was solved in this run. */
export function secondsLeft(progress: Progress, now_ms: number): number | null {
  const elapsed = elapsedSeconds(progress, now_ms);
  const solved = progress.done - (progress.reused ?? 0);
  if (elapsed === null || progress.total === null || solved <= 0 || progress.state !== "running") return null;
  return (elapsed / solved) * Math.max(0, progress.total - progress.done);
}

export function newtonIterations(progress: Progress): number {
  return [...progress.newton.values()].reduce((sum, count) => sum + count, 0);
}

function without(solves: readonly LiveSolve[], ordinal: number): readonly LiveSolve[] {
  return solves.filter((solve) => solve.ordinal !== ordinal);
}

/** The failed points with what an event adds; it may come after the end, when a stream is replayed. */
function failuresOf(known: readonly PointFailure[], event: StudyEvent): readonly PointFailure[] {
  let told: (Omit<FailedPoint, "values"> & { values?: number[] })[] = [];
  if (event.kind === "point-failed") told = [event];
  if (event.kind === "failed") told = event.failed_points ?? [];
  if (told.length === 0) return known;
  const points = new Map(known.map((point) => [point.ordinal, point]));
  for (const { ordinal, cause, values } of told) {
    points.set(ordinal, { ordinal, cause, values: values ?? points.get(ordinal)?.values ?? [] });
  }
  return [...points.values()].sort((a, b) => a.ordinal - b.ordinal);
}

/** A moment of the service in milliseconds since the epoch. */
export function milliseconds(text: string | null | undefined): number | null {
  const time = text == null ? Number.NaN : Date.parse(text);
  return Number.isNaN(time) ? null : time;
}
