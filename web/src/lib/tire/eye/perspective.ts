/** From places to pixels and back, as the picture is taken. */

import { eyeOf, type Orbit } from "./orbit.ts";
import type { Ray } from "./ray-pick.ts";
import { cross, dot, minus, unit, type Vec3 } from "../surface/skin-geometry.ts";

/** Angle between the picture's lower and upper edge, degrees. */
export const FIELD_OF_VIEW_DEG = 38;

/** An eye with a picture of so many CSS pixels. */
export interface Camera {
  orbit: Orbit;
  width: number;
  height: number;
}

/** The line of sight through a pixel. */
export function rayThrough(camera: Camera, x: number, y: number): Ray {
  const { origin, forward, right, up, half } = frameOf(camera);
  const [toRight, toTop] = [((2 * x) / camera.width - 1) * half * (camera.width / camera.height), (1 - (2 * y) / camera.height) * half];
  const direction = [0, 1, 2].map((i) => (forward[i] as number) + toRight * (right[i] as number) + toTop * (up[i] as number)) as Vec3;
  return { origin, direction: unit(direction) };
}

/** The pixel of a place; null behind the eye. */
export function pixelOf(camera: Camera, place: Vec3): { x: number; y: number } | null {
  const { origin, forward, right, up, half } = frameOf(camera);
  const from = minus(place, origin);
  const depth = dot(from, forward);
  if (depth <= 0) return null;
  const scale = camera.height / (2 * half * depth);
  return { x: camera.width / 2 + dot(from, right) * scale, y: camera.height / 2 - dot(from, up) * scale };
}

function frameOf({ orbit }: Camera): { origin: Vec3; forward: Vec3; right: Vec3; up: Vec3; half: number } {
  const origin = eyeOf(orbit);
  const forward = unit(minus(orbit.target, origin));
  const right = unit(cross(forward, [0, 0, 1]));
  return { origin, forward, right, up: cross(right, forward), half: Math.tan((FIELD_OF_VIEW_DEG * Math.PI) / 360) };
}
