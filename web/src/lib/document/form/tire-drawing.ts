/** The undeformed section of the tire and the ground below it as lines to draw, x and z in mm. Pure geometry of the document's own numbers. */

import type { Point } from "../../chart/paths.ts";
import { valueAt } from "../document-values.ts";
import { meanAt } from "./input-laws.ts";

export interface SectionOutline {
  /** Closed, from bead to bead outside and back inside; crown at z = 0, the axle above. */
  wall: Point[];
  /** Of the carcass' cords; null without them. */
  cords: Point[] | null;
}

/** Points of an arc of the section. */
const ARC_POINTS = 61;

/** The meridional section of the wall; null while its numbers make none. */
export function sectionOutline(document: unknown): SectionOutline | null {
  const [radius, wall, bead] = ["section_radius_mm", "wall_mm", "bead_angle_deg"].map((name) => meanAt(document, `/scene/geometry/${name}`)?.value);
  if (radius === undefined || wall === undefined || bead === undefined) return null;
  if (!(wall > 0 && wall < radius && bead > 0 && bead < 180)) return null;
  const place = meanAt(document, "/scene/carcass/position")?.value;
  return {
    wall: [...arc(radius, radius, bead), ...arc(radius, radius - wall, bead).reverse()],
    cords: place === undefined ? null : arc(radius, radius - wall + wall * Math.min(1, Math.max(0, place)), bead),
  };
}

/** About the middle of the section, which lies a section's radius above the crown. */
function arc(middle: number, radius: number, bead_deg: number): Point[] {
  return Array.from({ length: ARC_POINTS }, (_, index): Point => {
    const phi = (((2 * index) / (ARC_POINTS - 1) - 1) * bead_deg * Math.PI) / 180;
    return [radius * Math.sin(phi), middle - radius * Math.cos(phi)];
  });
}

interface StationMark {
  name: string;
  x_mm: number;
  depth_mm: number;
  /** How far the depth reaches about there; 0 where it doesn't vary. */
  half_mm: number;
}

export interface ContactOutline {
  /** The tire's outer line around the wheel, its lowest point at z = 0. */
  tire: Point[];
  /** The inner one. */
  inner: Point[];
  ground: Point[];
  stations: StationMark[];
}

const GROUND_POINTS = 121;

/** The crown over the ground, along the wheel; null where a force presses, or the numbers make none. */
export function contactOutline(document: unknown): ContactOutline | null {
  const number = (pointer: string): number | undefined => meanAt(document, `/scene/${pointer}`)?.value;
  const [outer, wall, spacing] = [number("geometry/outer_radius_mm"), number("geometry/wall_mm"), number("ground/station_spacing_mm")];
  const depths = valueAt(document, "/scene/ground/depths_mm");
  if (outer === undefined || wall === undefined || spacing === undefined || !Array.isArray(depths)) return null;
  if (!(outer > wall && wall > 0 && spacing > 0) || depths.length === 0) return null;
  const stations = depths.map((_, index): StationMark => {
    const mean = meanAt(document, `/scene/ground/depths_mm/${index}`);
    const x_mm = (index - (depths.length - 1) / 2) * spacing;
    return { name: `P${index + 1}`, x_mm, depth_mm: mean?.value ?? 0, half_mm: mean?.half ?? 0 };
  });
  const reach = Math.min(((depths.length - 1) / 2 + 1) * spacing, outer * 0.95);
  const isHat = valueAt(document, "/scene/ground/station_functions") === "hat";
  const along = (height: (x: number) => number): Point[] =>
    Array.from({ length: GROUND_POINTS }, (_, index): Point => {
      const x = ((2 * index) / (GROUND_POINTS - 1) - 1) * reach;
      return [x, height(x)];
    });
  return {
    tire: along((x) => outer - Math.sqrt(outer ** 2 - x ** 2)),
    inner: along((x) => outer - Math.sqrt(Math.max(0, (outer - wall) ** 2 - x ** 2))),
    ground: along((x) =>
      groundHeight(
        stations.map(({ depth_mm }) => depth_mm),
        spacing,
        isHat,
        x,
      ),
    ),
    stations,
  };
}

/** Height of the ground above the tire's lowest point: the stations' functions, those beyond the ends added to the end stations'. */
export function groundHeight(depths_mm: readonly number[], spacing_mm: number, isHat: boolean, x_mm: number): number {
  const at = x_mm / spacing_mm + (depths_mm.length - 1) / 2;
  let height = 0;
  for (let station = Math.floor(at) - 1; station <= Math.floor(at) + 2; station += 1) {
    const depth = depths_mm[Math.min(depths_mm.length - 1, Math.max(0, station))] ?? 0;
    height += depth * (isHat ? hat(at - station) : cubicSpline(at - station));
  }
  return height;
}

function hat(t: number): number {
  return Math.max(0, 1 - Math.abs(t));
}

/** The uniform cubic B-spline, 2/3 at its middle and zero from 2 on. */
function cubicSpline(t: number): number {
  const s = Math.abs(t);
  if (s >= 2) return 0;
  return s < 1 ? 2 / 3 - s ** 2 + s ** 3 / 2 : (2 - s) ** 3 / 6;
}
