/** Layouts' errors over the number of units as curves to draw: one for each position in the section and set of films. */

import type { LayoutScore, RankedLayout } from "../../wire.ts";
import { filmSet, isPapers } from "./layout-words.ts";

/** The layouts' worst loads, or one of the loads by its place in the list. */
export type ShownLoad = "worst" | number;

interface CurvePoint {
  layout: RankedLayout;
  units: number;
  spacing_deg: number;
  /** 95 % of simulated contacts are estimated better, degrees. */
  error_deg: number;
  /** Ends of its error bar. */
  low_deg: number;
  high_deg: number;
  is_papers: boolean;
}

export interface LayoutCurve {
  position: string;
  films: string;
  points: CurvePoint[];
}

/** No angle is further away than half a turn. */
const HALF_TURN_DEG = 180;

/** 95 % of blind guesses are off by less than this, degrees. */
export const GUESS_DEG = 0.95 * HALF_TURN_DEG;

/** In the order in which positions and sets of films come in the ranking. */
export function curves(layouts: RankedLayout[], load: ShownLoad): LayoutCurve[] {
  const found = new Map<string, LayoutCurve>();
  for (const layout of layouts) {
    const point = pointOf(layout, load);
    if (point === null) continue;
    const films = filmSet(layout.films, layout.staggered);
    const key = `${layout.position}\n${films}`;
    const curve = found.get(key) ?? { position: layout.position, films, points: [] };
    curve.points.push(point);
    found.set(key, curve);
  }
  const all = [...found.values()];
  for (const { points } of all) points.sort((a, b) => a.units - b.units);
  return all;
}

/** A layout's score at a load; at its worst load, the one that it is ranked by. */
export function scoreAt(layout: RankedLayout, load: ShownLoad): LayoutScore | null {
  return load === "worst" ? layout.score : (layout.loads[load]?.score ?? null);
}

function pointOf(layout: RankedLayout, load: ShownLoad): CurvePoint | null {
  const score = scoreAt(layout, load);
  const value = score?.simulated_p95_angle_error_deg;
  if (layout.spacing_deg == null || value == null || !(value > 0)) return null;
  const error = score?.error?.simulated_p95_angle_error_deg ?? 0;
  return {
    layout,
    units: layout.units,
    spacing_deg: layout.spacing_deg,
    error_deg: value,
    low_deg: Math.max(0, value - error),
    high_deg: Math.max(value, Math.min(HALF_TURN_DEG, value + error)),
    is_papers: isPapers(layout),
  };
}

/** Ends of a logarithmic scale of degrees at 1, 2 or 5 times a power of ten; half a turn at the top. */
export function errorRange(all: LayoutCurve[]): [number, number] {
  const values = all.flatMap((curve) => curve.points.map((point) => Math.max(point.low_deg, point.error_deg / 2)));
  const least = Math.min(HALF_TURN_DEG / 2, ...values);
  const power = 10 ** Math.floor(Math.log10(least));
  const low = [5, 2, 1].map((factor) => factor * power).find((step) => step <= least) ?? power;
  return [low, HALF_TURN_DEG];
}

/** Numbers of units that are written at the axis: those that stand so far apart there, one number before the others. */
export function unitTicks(all: readonly number[], first: number, at: (units: number) => number, apart: number): number[] {
  const units = [...new Set(all)].sort((a, b) => a - b);
  const kept: number[] = [];
  for (const unit of [...units.filter((count) => count === first), ...units]) {
    if (kept.every((other) => Math.abs(at(unit) - at(other)) >= apart)) kept.push(unit);
  }
  return kept.sort((a, b) => a - b);
}
