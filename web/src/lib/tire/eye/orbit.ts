/** Where the eye is: on a sphere about the place that is looked at. */

import type { Vec3 } from "../surface/skin-geometry.ts";

export interface Orbit {
  /** About the vertical, degrees; 0 looks along the axle with the rolling direction to the right, 90 against the rolling direction. */
  azimuth_deg: number;
  /** Above the horizon, degrees. */
  elevation_deg: number;
  /** From the place that is looked at, mm. */
  distance_mm: number;
  target: Vec3;
}

export const VIEW_NAMES = ["start", "front", "side", "top", "section"] as const;
export type ViewName = (typeof VIEW_NAMES)[number];

/** Straight up or down has no side: the eye stays a little off it. */
export const MOST_ELEVATION = 89.5;
const [NEAREST, FARTHEST] = [0.25, 4];

/** A view of a wheel of this radius. */
export function viewOf(name: ViewName, radius_mm: number): Orbit {
  const whole = { distance_mm: 4 * radius_mm, target: [0, 0, 0] as Vec3 };
  switch (name) {
    case "front":
      return { ...whole, azimuth_deg: 90, elevation_deg: 0 };
    case "side":
      return { ...whole, azimuth_deg: 0, elevation_deg: 0 };
    case "top":
      return { ...whole, azimuth_deg: 0, elevation_deg: MOST_ELEVATION };
    case "section":
      return { azimuth_deg: 0, elevation_deg: 16, distance_mm: 1.5 * radius_mm, target: [0, 0, -0.8 * radius_mm] };
    case "start":
      return { azimuth_deg: -24, elevation_deg: 30, distance_mm: 3.6 * radius_mm, target: [0, 0, -0.11 * radius_mm] };
  }
}

/** Turned by so many degrees. */
export function turnedBy(orbit: Orbit, azimuth_deg: number, elevation_deg: number): Orbit {
  const elevation = Math.min(MOST_ELEVATION, Math.max(-MOST_ELEVATION, orbit.elevation_deg + elevation_deg));
  return { ...orbit, azimuth_deg: orbit.azimuth_deg + azimuth_deg, elevation_deg: elevation };
}

/** Nearer by a factor above one, farther below, within reason for a wheel of this radius. */
export function nearer(orbit: Orbit, factor: number, radius_mm: number): Orbit {
  const distance = Math.min(FARTHEST * 2 * radius_mm, Math.max(NEAREST * radius_mm, orbit.distance_mm / factor));
  return { ...orbit, distance_mm: distance };
}

/** An orbit about a wheel of radius 1 about one of this radius. */
export function aboutWheel(orbit: Orbit, radius_mm: number): Orbit {
  return { ...orbit, distance_mm: orbit.distance_mm * radius_mm, target: orbit.target.map((value) => value * radius_mm) as Vec3 };
}

/** Where the eye is. */
export function eyeOf({ azimuth_deg, elevation_deg, distance_mm, target }: Orbit): Vec3 {
  const [azimuth, elevation] = [(azimuth_deg * Math.PI) / 180, (elevation_deg * Math.PI) / 180];
  const level = distance_mm * Math.cos(elevation);
  return [target[0] + level * Math.sin(azimuth), target[1] - level * Math.cos(azimuth), target[2] + distance_mm * Math.sin(elevation)];
}

/** Part of the way from one view to another, the shorter way round. */
export function betweenViews(from: Orbit, to: Orbit, share: number): Orbit {
  const mix = (a: number, b: number): number => a + share * (b - a);
  const turn = ((((to.azimuth_deg - from.azimuth_deg + 180) % 360) + 360) % 360) - 180;
  return {
    azimuth_deg: from.azimuth_deg + share * turn,
    elevation_deg: mix(from.elevation_deg, to.elevation_deg),
    distance_mm: mix(from.distance_mm, to.distance_mm),
    target: from.target.map((value, i) => mix(value, to.target[i] as number)) as Vec3,
  };
}
