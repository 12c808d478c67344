/** The wheel as it is drawn: the mesh's points about the contact, few and evenly round ones elsewhere. */

import { bracket, type Bracket } from "../map/map-grid.ts";
import type { Skin, Surface } from "./surface-reader.ts";

/** Between columns beyond the sector, degrees: elements there are up to 45 degrees long, and would look like a polygon. */
const STEP_DEG = 7.5;
/** Rows beyond these are left out by halves: software draws 10 000 triangles in time. */
const MOST_ROWS = 30;

/** A point by its distance from the axle, its angle and its place along the axle. */
type Polar = readonly [radius: number, angle: number, axial: number];

/** Columns within the sector stay as they are; beyond it the mesh's points are joined by arcs. */
export function drawnWheel(surface: Surface, sector: readonly [number, number]): Surface {
  const rows = keptRows(surface.phi_deg.length);
  const theta_deg = drawnAngles(surface.theta_deg, sector);
  const columns = theta_deg.map((theta) => bracket(surface.theta_deg, theta) ?? { at: 0, share: 0 });
  const skin = (whole: Skin): Skin => redrawn(whole, surface.theta_deg.length, rows, columns);
  return {
    ...surface,
    theta_deg,
    phi_deg: rows.map((row) => surface.phi_deg[row] as number),
    inner: skin(surface.inner),
    outer: surface.outer === null ? null : skin(surface.outer),
  };
}

/** Every row, or every second and so on; both beads and the crown stay. */
function keptRows(count: number): number[] {
  let stride = 1;
  while ((count - 1) / stride + 1 > MOST_ROWS && (count - 1) % (4 * stride) === 0) stride *= 2;
  return Array.from({ length: (count - 1) / stride + 1 }, (_, k) => k * stride);
}

function drawnAngles(theta_deg: readonly number[], [low, high]: readonly [number, number]): number[] {
  const inside = theta_deg.filter((theta) => theta >= low && theta <= high);
  const [first, last] = [inside[0] ?? 0, inside[inside.length - 1] ?? 0];
  const from = (start: number, end: number): number[] => {
    const steps = Math.max(1, Math.round((end - start) / STEP_DEG));
    return Array.from({ length: steps + 1 }, (_, k) => start + ((end - start) * k) / steps);
  };
  const [start, end] = [theta_deg[0] as number, theta_deg[theta_deg.length - 1] as number];
  return [...from(start, first).slice(0, -1), ...inside, ...from(last, end).slice(1)];
}

function redrawn(whole: Skin, width: number, rows: readonly number[], columns: readonly Bracket[]): Skin {
  const skin: Skin = { inflated: new Float32Array(3 * rows.length * columns.length), displacement: new Float32Array(3 * rows.length * columns.length) };
  rows.forEach((row, i) =>
    columns.forEach(({ at, share }, j) => {
      const to = 3 * (i * columns.length + j);
      const [from, next] = [3 * (row * width + at), 3 * (row * width + at + 1)];
      if (share === 0 || share === 1) return copy(skin, to, whole, share === 0 ? from : next);
      const still = between(polar(whole, from, 0), polar(whole, next, 0), share);
      const moved = between(polar(whole, from, 1), polar(whole, next, 1), share);
      skin.inflated.set(still, to);
      skin.displacement.set(
        moved.map((value, k) => value - (still[k] as number)),
        to,
      );
    }),
  );
  return skin;
}

function copy(skin: Skin, to: number, whole: Skin, from: number): void {
  skin.inflated.set(whole.inflated.subarray(from, from + 3), to);
  skin.displacement.set(whole.displacement.subarray(from, from + 3), to);
}

function polar({ inflated, displacement }: Skin, k: number, factor: number): Polar {
  const [x, y, z] = [0, 1, 2].map((i) => (inflated[k + i] as number) + factor * (displacement[k + i] as number)) as [number, number, number];
  return [Math.hypot(x, z), Math.atan2(x, -z), y];
}

function between([r0, a0, y0]: Polar, [r1, a1, y1]: Polar, share: number): [number, number, number] {
  const turn = Math.atan2(Math.sin(a1 - a0), Math.cos(a1 - a0));
  const [radius, angle] = [r0 + share * (r1 - r0), a0 + share * turn];
  return [radius * Math.sin(angle), y0 + share * (y1 - y0), -radius * Math.cos(angle)];
}
