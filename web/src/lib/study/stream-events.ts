/** The events of a study's stream. Written by hand: the service's description has their JSON as a text. */

import type { FailedPoint, LiveSolve } from "../../wire.ts";

export type StudyEvent =
  | { kind: "queued" }
  | { kind: "started"; points: number; reused: number }
  | { kind: "solving"; solves: LiveSolve[] }
  | { kind: "point-solved"; ordinal: number; done: number; of: number; wall_s: number; newton_iterations: number }
  | { kind: "point-failed"; ordinal: number; done: number; of: number; cause: string }
  | { kind: "analysing" }
  | { kind: "done" }
  | { kind: "failed"; error: string; failed_points?: FailedPoint[] }
  | { kind: "cancelled" };

export const EVENT_KINDS: readonly StudyEvent["kind"][] = [
  "queued",
  "started",
  "solving",
  "point-solved",
  "point-failed",
  "analysing",
  "done",
  "failed",
  "cancelled",
];
