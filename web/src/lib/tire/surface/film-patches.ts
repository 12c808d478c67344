/** Films of a layout, and the patches that they cover on the inner skin. */

import type { FilmPlace, RankedLayout } from "../../../wire.ts";
import type { Rgb } from "../../chart/colour.ts";
import type { MapGrid, SurfacePoint } from "../map/map-grid.ts";
import { cross, minus, placeOn, unit, type Vec3 } from "./skin-geometry.ts";
import type { Skin } from "./surface-reader.ts";

/** Length along the film's angle and width across it, mm. */
export type PatchSize = readonly [length_mm: number, width_mm: number];

/** A film on the tire; without a colour of its own it is dark. */
export type ShownFilm = FilmPlace & { colour?: Rgb };

/** Points of a patch along each side. */
const SIDE = 7;
/** Above the skin, mm, so that neither hides the other. */
const LIFT_MM = 0.25;

/** Section angles of the positions that have a name, degrees. */
export const POSITIONS: Record<string, number> = { crown: 0, shoulder: 45, sidewall: 90 };

/** The films of a layout, wheel angles in [-180, 180). */
export function filmsOf(layout: RankedLayout): FilmPlace[] {
  if (layout.places != null && layout.places.length > 0) return layout.places.map((place) => ({ ...place, theta_deg: wrapped(place.theta_deg) }));
  const spacing = layout.spacing_deg ?? 360 / layout.units;
  const phi_deg = POSITIONS[layout.position] ?? Number.parseFloat(layout.position);
  if (!Number.isFinite(phi_deg)) return [];
  // Films of staggered units are spread evenly between two units.
  const offset = (film: number): number => (layout.staggered === true ? (spacing * film) / layout.films.length : 0);
  return Array.from({ length: layout.units }, (_, unitAt) =>
    layout.films.map((direction, film) => ({
      theta_deg: wrapped((layout.turn_deg ?? 0) + unitAt * spacing + offset(film)),
      phi_deg,
      angle_deg: angleOf(direction),
    })),
  ).flat();
}

function angleOf(direction: string): number {
  return direction === "x" ? 0 : direction === "y" ? 90 : Number.parseFloat(direction);
}

function wrapped(theta_deg: number): number {
  return ((((theta_deg + 180) % 360) + 360) % 360) - 180;
}

/** Corners of a film about its place, mm along the wheel and along the section. */
export function cornersOfFilm([length, width]: PatchSize, angle_deg: number): [number, number][] {
  const signs = [
    [-1, -1],
    [1, -1],
    [1, 1],
    [-1, 1],
  ] as const;
  return signs.map(([u, v]) => rotated((u * length) / 2, (v * width) / 2, angle_deg));
}

function rotated(u: number, v: number, angle_deg: number): [number, number] {
  const angle = (angle_deg * Math.PI) / 180;
  return [u * Math.cos(angle) - v * Math.sin(angle), u * Math.sin(angle) + v * Math.cos(angle)];
}

/** A patch on the skin as a grid of points with triangles; null where the skin doesn't reach. */
export function patchOn(grid: MapGrid, skin: Skin, film: FilmPlace, size: PatchSize, isRound: boolean): Skin | null {
  const frame = frameAt(grid, skin.inflated, film);
  if (frame === null) return null;
  const patch: Skin = { inflated: new Float32Array(3 * SIDE * SIDE), displacement: new Float32Array(3 * SIDE * SIDE) };
  for (let k = 0; k < SIDE * SIDE; k += 1) {
    const square: [number, number] = [(2 * (k % SIDE)) / (SIDE - 1) - 1, (2 * Math.floor(k / SIDE)) / (SIDE - 1) - 1];
    const [s, t] = isRound ? onDisc(square) : square;
    const [along, across] = rotated((s * size[0]) / 2, (t * size[1]) / 2, film.angle_deg);
    const place = { theta_deg: film.theta_deg + along / frame.mmPerTheta, phi_deg: film.phi_deg + across / frame.mmPerPhi };
    const [at, moved] = [placeOn(grid, skin.inflated, place), placeOn(grid, skin.displacement, place)];
    if (at === null || moved === null) return null;
    patch.inflated.set(
      at.map((value, i) => value + LIFT_MM * (frame.normal[i] as number)),
      3 * k,
    );
    patch.displacement.set(moved, 3 * k);
  }
  return patch;
}

/** Angles of a patch's points, so that its triangles are those of a grid. */
export const PATCH_GRID: MapGrid = { theta_deg: Array.from({ length: SIDE }, (_, k) => k), phi_deg: Array.from({ length: SIDE }, (_, k) => k) };

/** The square's points on a disc, evenly. */
function onDisc([s, t]: [number, number]): [number, number] {
  return [s * Math.sqrt(1 - (t * t) / 2), t * Math.sqrt(1 - (s * s) / 2)];
}

/** Lengths of a degree, and the normal into the cavity. */
function frameAt(grid: MapGrid, points: Float32Array, { theta_deg, phi_deg }: SurfacePoint): { mmPerTheta: number; mmPerPhi: number; normal: Vec3 } | null {
  const step = 1;
  const at = (theta: number, phi: number): Vec3 | null => placeOn(grid, points, { theta_deg: theta, phi_deg: phi });
  const [west, east] = [at(theta_deg - step, phi_deg), at(theta_deg + step, phi_deg)];
  const [south, north] = [at(theta_deg, phi_deg - step), at(theta_deg, phi_deg + step)];
  if (west === null || east === null || south === null || north === null) return null;
  const [along, across] = [minus(east, west), minus(north, south)];
  return { mmPerTheta: Math.hypot(...along) / (2 * step), mmPerPhi: Math.hypot(...across) / (2 * step), normal: unit(cross(along, across)) };
}
