/** What a line of sight meets first on the inner skin. */

import type { MapGrid, SurfacePoint } from "../map/map-grid.ts";
import { cross, dot, minus, type Vec3 } from "../surface/skin-geometry.ts";

export interface Ray {
  origin: Vec3;
  direction: Vec3;
}

interface Hit extends SurfacePoint {
  /** In lengths of the ray's direction. */
  distance: number;
  position: Vec3;
}

/** The nearest triangle's place in angles of the undeformed tire; positions that aren't shown are looked through. */
export function pick(grid: MapGrid, points: Float32Array, triangles: Uint32Array, ray: Ray, isShown: (position: Vec3) => boolean): Hit | null {
  let best: Hit | null = null;
  for (let k = 0; k + 2 < triangles.length; k += 3) {
    const corners = [triangles[k] as number, triangles[k + 1] as number, triangles[k + 2] as number] as const;
    const met = meet(corners.map((corner) => pointAt(points, corner)) as [Vec3, Vec3, Vec3], ray);
    if (met === null || (best !== null && met.distance >= best.distance)) continue;
    const position = [0, 1, 2].map((i) => (ray.origin[i] as number) + met.distance * (ray.direction[i] as number)) as Vec3;
    if (isShown(position)) best = { ...anglesOf(grid, corners, met.weights), distance: met.distance, position };
  }
  return best;
}

function pointAt(points: Float32Array, index: number): Vec3 {
  return [points[3 * index] as number, points[3 * index + 1] as number, points[3 * index + 2] as number];
}

/** Möller and Trumbore (1997): the distance along the ray, and how much each corner counts. */
function meet([a, b, c]: [Vec3, Vec3, Vec3], { origin, direction }: Ray): { distance: number; weights: Vec3 } | null {
  const [toB, toC] = [minus(b, a), minus(c, a)];
  const across = cross(direction, toC);
  const determinant = dot(toB, across);
  if (Math.abs(determinant) < 1e-12) return null;
  const from = minus(origin, a);
  const ofB = dot(from, across) / determinant;
  if (ofB < 0 || ofB > 1) return null;
  const along = cross(from, toB);
  const ofC = dot(direction, along) / determinant;
  if (ofC < 0 || ofB + ofC > 1) return null;
  const distance = dot(toC, along) / determinant;
  return distance > 0 ? { distance, weights: [1 - ofB - ofC, ofB, ofC] } : null;
}

/** Angles run evenly over a triangle: its corners are points of the grid. */
function anglesOf({ theta_deg, phi_deg }: MapGrid, corners: readonly number[], weights: Vec3): SurfacePoint {
  const columns = theta_deg.length;
  const mean = (angle: (corner: number) => number): number => corners.reduce((sum, corner, i) => sum + (weights[i] as number) * angle(corner), 0);
  return {
    theta_deg: mean((corner) => theta_deg[corner % columns] as number),
    phi_deg: mean((corner) => phi_deg[Math.floor(corner / columns)] as number),
  };
}
