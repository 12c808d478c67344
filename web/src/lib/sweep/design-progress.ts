/** How far a sweep is, and what its designs set. Pure: time comes in as a number. */

import type { AwaySweep, DesignView, State, SweepDetail, SweepSummary } from "../../wire.ts";
import { isOver, share } from "../study/point-progress.ts";

/** In the order in which designs go through them. */
const STATES: readonly State[] = ["queued", "running", "done", "failed", "cancelled"];

export function designsOf(sweep: SweepSummary): number {
  return STATES.reduce((sum, state) => sum + sweep.counts[state], 0);
}

/** Designs that have ended, with or without a result. */
export function designsOver(sweep: SweepSummary): number {
  return STATES.filter(isOver).reduce((sum, state) => sum + sweep.counts[state], 0);
}

/** Designs by state in words, the states that none is in left out. */
export function countsText(sweep: SweepSummary): string {
  return STATES.filter((state) => sweep.counts[state] > 0)
    .map((state) => `${sweep.counts[state]} ${state}`)
    .join(", ");
}

/** Tasks of a sweep on other machines by where they stand, in words. */
export function tasksText({ tasks, because }: Pick<AwaySweep, "tasks" | "because">): string {
  const reason = because == null ? "" : ` (${because})`;
  const parts: [number, string][] = [
    [tasks.waiting, `${tasks.waiting} waiting${reason}`],
    [tasks.running, `${tasks.running} running`],
    [tasks.ended, `${tasks.ended} ended`],
  ];
  const told = parts.filter(([count]) => count > 0).map(([, words]) => words);
  return told.length === 0 ? "being made" : told.join(", ");
}

/** Designs that a resumption would put back into the queue. */
export function designsToResume(sweep: SweepSummary): number {
  return sweep.counts.failed + sweep.counts.cancelled;
}

/** How many designs' worth of work is done: one for each that has ended, a share for each that is at work and in view. */
function workDone(sweep: SweepDetail): number {
  const atWork = sweep.designs.filter(({ study }) => !isOver(study.state));
  return atWork.reduce((sum, { study }) => sum + share({ total: study.points_total ?? null, done: study.points_done }), designsOver(sweep));
}

/** Share of the designs that is done, 0 to 1. Points can't say so: the plan of a design is known when it starts. */
export function sweepShare(sweep: SweepDetail): number {
  const all = designsOf(sweep);
  return all === 0 ? 0 : workDone(sweep) / all;
}

/** Seconds left at the pace so far; null before anything of a design is done, and when nothing is at work. */
export function sweepSecondsLeft(sweep: SweepDetail): number | null {
  const done = workDone(sweep);
  if (isOver(sweep.state) || done <= 0) return null;
  return (sweep.worked_s / done) * (designsOf(sweep) - done);
}

/** A path that designs set, and its values in the order of the designs. */
export interface Varied {
  path: string;
  values: string[];
}

/** What designs set, path by path. */
export function variedPaths(designs: readonly DesignView[]): Varied[] {
  const paths = new Map<string, Set<string>>();
  for (const { set } of designs) {
    for (const [path, value] of Object.entries(set)) {
      paths.set(path, (paths.get(path) ?? new Set()).add(valueText(value)));
    }
  }
  return [...paths].map(([path, values]) => ({ path, values: [...values] }));
}

/** A value as it is written in a document, texts without quotes. */
export function valueText(value: unknown): string {
  return typeof value === "string" ? value : JSON.stringify(value);
}

/** What a design sets, in full: `geometry.wall_mm = 2.5, carcass.angle_deg = 50`. */
export function settingsText(set: DesignView["set"]): string {
  return Object.entries(set)
    .map(([path, value]) => `${path} = ${valueText(value)}`)
    .join(", ");
}

/** Whether a design's name says what it sets, as the names do that the service gives. */
export function nameSaysAll({ name, set }: DesignView): boolean {
  return Object.values(set).every((value) => name.includes(` = ${valueText(value)}`));
}
