/** Lengths along the inner surface, so that the map is drawn to scale. */

import type { MapShape } from "../../../wire.ts";
import { bracket, type MapGrid } from "./map-grid.ts";

type Point = readonly number[];

/** Angles with their distances from zero. */
export interface Ruler {
  angles: readonly number[];
  /** Ascending with the angles; mm, or degrees where the shape isn't known. */
  marks: readonly number[];
}

/** The rulers of a map: along the crown, and along the section through the contact centre. */
export interface Rulers {
  along: Ruler;
  across: Ruler;
  unit: "mm" | "°";
}

export function rulersOf(grid: MapGrid, shape: MapShape | undefined): Rulers {
  const { theta_deg, phi_deg } = grid;
  const columns = theta_deg.length;
  const crown = closestToZero(phi_deg);
  const centre = closestToZero(theta_deg);
  const inflated = shape?.inflated_mm;
  if (inflated === undefined || inflated.length !== columns * phi_deg.length) {
    return { along: { angles: theta_deg, marks: theta_deg }, across: { angles: phi_deg, marks: phi_deg }, unit: "°" };
  }
  const along = theta_deg.map((_, column) => inflated[crown * columns + column] as Point);
  const across = phi_deg.map((_, row) => inflated[row * columns + centre] as Point);
  return { along: ruler(theta_deg, along), across: ruler(phi_deg, across), unit: "mm" };
}

/** The mark at an angle; ends are extended straight on. */
export function markAt({ angles, marks }: Ruler, angle: number): number {
  return straight(angles, marks, angle);
}

/** The angle at a mark. */
export function angleAt({ angles, marks }: Ruler, mark: number): number {
  return straight(marks, angles, mark);
}

/** First and last mark. */
export function endsOf({ marks }: Ruler): [number, number] {
  return [marks[0] ?? 0, marks[marks.length - 1] ?? 0];
}

function straight(from: readonly number[], to: readonly number[], value: number): number {
  if (from.length < 2) return value - (from[0] ?? 0) + (to[0] ?? 0);
  const inside = bracket(from, value);
  const at = inside?.at ?? (value < (from[0] as number) ? 0 : from.length - 2);
  const share = inside?.share ?? (value - (from[at] as number)) / ((from[at + 1] as number) - (from[at] as number));
  return (to[at] as number) + share * ((to[at + 1] as number) - (to[at] as number));
}

/** Arc lengths along points of a curve, zero at the angle zero. */
function ruler(angles: readonly number[], points: readonly Point[]): Ruler {
  const marks = [0];
  points.slice(1).forEach((_, k) => marks.push((marks[k] as number) + arc(points, k)));
  const zero = straight(angles, marks, 0);
  return { angles, marks: marks.map((mark) => mark - zero) };
}

/** Length of a curve from point k to the next: the chord, lengthened as on a circle that turns as the chords beside it do. */
function arc(points: readonly Point[], k: number): number {
  const turns = [turn(points, k), turn(points, k + 1)].filter((angle) => angle !== null);
  const half = turns.reduce((sum, angle) => sum + angle, 0) / (2 * Math.max(1, turns.length));
  const chord = Math.hypot(...step(points, k));
  return half < 1e-6 ? chord : (chord * half) / Math.sin(half);
}

/** Angle between the two chords that meet in a point; null at the ends. */
function turn(points: readonly Point[], k: number): number | null {
  if (k < 1 || k > points.length - 2) return null;
  const [a, b] = [step(points, k - 1), step(points, k)];
  const cosine = a.reduce((sum, value, i) => sum + value * (b[i] as number), 0) / (Math.hypot(...a) * Math.hypot(...b));
  return Number.isFinite(cosine) ? Math.acos(Math.min(1, Math.max(-1, cosine))) : 0;
}

function step(points: readonly Point[], k: number): number[] {
  const [from, to] = [points[k] as Point, points[k + 1] as Point];
  return from.map((value, i) => (to[i] as number) - value);
}

function closestToZero(values: readonly number[]): number {
  return values.reduce((best, value, index) => (Math.abs(value) < Math.abs(values[best] as number) ? index : best), 0);
}
