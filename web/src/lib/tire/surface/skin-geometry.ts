/** Skins as triangles: which points they join, where these are, and how they face. */

import { cornersAt, type MapGrid, type SurfacePoint } from "../map/map-grid.ts";
import type { Skin } from "./surface-reader.ts";

export type Vec3 = [number, number, number];

/** Corners of the triangles of a grid, two a cell. */
export function trianglesOf({ theta_deg, phi_deg }: MapGrid): Uint32Array {
  const [rows, columns] = [phi_deg.length, theta_deg.length];
  const corners: number[] = [];
  for (let row = 0; row + 1 < rows; row += 1) {
    for (let column = 0; column + 1 < columns; column += 1) {
      const a = row * columns + column;
      corners.push(a, a + 1, a + columns + 1, a, a + columns + 1, a + columns);
    }
  }
  return Uint32Array.from(corners);
}

/** Positions after a multiple of the displacement. */
export function deformed({ inflated, displacement }: Skin, factor: number): Float32Array {
  return inflated.map((value, k) => value + factor * (displacement[k] as number));
}

/** Where a place of the grid is on a skin; null outside the grid. */
export function placeOn(grid: MapGrid, points: Float32Array, place: SurfacePoint): Vec3 | null {
  const corners = cornersAt(grid, turned(grid, place));
  if (corners === null) return null;
  const at = (k: 0 | 1 | 2): number => corners.reduce((sum, { index, weight }) => sum + weight * (points[3 * index + k] as number), 0);
  return [at(0), at(1), at(2)];
}

/** The same place by a wheel angle within the grid, if a whole turn leads there. */
function turned({ theta_deg }: MapGrid, { theta_deg: theta, phi_deg }: SurfacePoint): SurfacePoint {
  const first = theta_deg[0] ?? 0;
  const last = theta_deg[theta_deg.length - 1] ?? 0;
  const turns = theta < first ? Math.ceil((first - theta) / 360) : theta > last ? -Math.ceil((theta - last) / 360) : 0;
  return { theta_deg: theta + 360 * turns, phi_deg };
}

/** Unit normals of a skin's points, towards the cavity. */
export function normalsOf({ theta_deg, phi_deg }: MapGrid, points: Float32Array): Float32Array {
  const [rows, columns] = [phi_deg.length, theta_deg.length];
  const isRound = (theta_deg[columns - 1] as number) - (theta_deg[0] as number) >= 360;
  const normals = new Float32Array(points.length);
  const at = (row: number, column: number): Vec3 => {
    const k = 3 * (row * columns + column);
    return [points[k] as number, points[k + 1] as number, points[k + 2] as number];
  };
  for (let row = 0; row < rows; row += 1) {
    for (let column = 0; column < columns; column += 1) {
      const [before, after] = neighbours(column, columns, isRound);
      const along = minus(at(row, after), at(row, before));
      const across = minus(at(Math.min(rows - 1, row + 1), column), at(Math.max(0, row - 1), column));
      normals.set(unit(cross(along, across)), 3 * (row * columns + column));
    }
  }
  return normals;
}

function neighbours(column: number, columns: number, isRound: boolean): [number, number] {
  if (!isRound) return [Math.max(0, column - 1), Math.min(columns - 1, column + 1)];
  return [column === 0 ? columns - 2 : column - 1, column === columns - 1 ? 1 : column + 1];
}

export function minus(a: Vec3, b: Vec3): Vec3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function cross(a: Vec3, b: Vec3): Vec3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function unit(a: Vec3): Vec3 {
  const length = Math.hypot(...a) || 1;
  return [a[0] / length, a[1] / length, a[2] / length];
}
