/** What a look says, in words. */

import { duration, integer, significant } from "../format.ts";
import type { ColumnLook, Look, RecordingLook } from "../../wire.ts";

/** What a column is taken for, with its unit. */
export function takenWords({ taken, force, column, newtons, time_unit }: ColumnLook): string {
  if (taken === "time") return time_unit === "seconds" ? "time, s" : `time, ${time_unit ?? "seconds"} made s`;
  if (taken === "force") return newtons === 1 ? "force, N" : `force, made N${force === column ? "" : ` as ${force ?? ""}`}`;
  return taken;
}

/** A recording as a whole. */
export function recordingFacts({ rows, duration_s, rate_hz, gaps, cycles, labelled }: RecordingLook): [string, string][] {
  const { count, longest } = gaps;
  return [
    ["Rows", integer(rows)],
    ["Length", duration(duration_s)],
    ["Rows a second", significant(rate_hz, 4)],
    ["Gaps", longest == null ? "none" : `${integer(count)}, the longest of ${duration(longest.length_s)} after line ${integer(longest.line)}`],
    ["Cycles", integer(cycles)],
    ["Rows with a force", integer(labelled)],
  ];
}

/** The figures of a column behind its range. */
export const figures = ({ empty, noise, unloaded, drift }: ColumnLook): string[] => [
  integer(empty),
  significant(noise, 3),
  significant(unloaded, 4),
  significant(drift, 3),
];

/** What a reader has to look at: suspect columns. */
export const suspicions = ({ columns }: RecordingLook): string[] => columns.flatMap(({ suspicions }) => suspicions);

/** The answer in a sentence. */
export function lookSentence({ recordings, faults, refusals }: Look): string {
  const count = recordings.flatMap(suspicions).length;
  if (recordings.length === 0) return "No recording can be read.";
  if (faults.length > 0) return "Not every recording can be read.";
  if (refusals.length > 0) return "All recordings can be read, and nothing would be learnt from them as they are.";
  if (count === 0) return "All recordings can be read, and nothing looks wrong.";
  return `All recordings can be read; ${count === 1 ? "one thing looks" : `${count} things look`} wrong.`;
}
