/** Where a layout's films are on the wheel, and where that is in a drawing. */

import type { RankedLayout, SheetFilm } from "../../wire.ts";

/** A film by its place in the wheel's own angles, which turn with it. */
export interface WheelFilm {
  /** Around the wheel, degrees. */
  theta_deg: number;
  /** From the crown, degrees. */
  section_deg: number;
  /** Of its length to the circumferential direction, degrees: 0 is x, 90 is y. */
  angle_deg: number;
}

const POSITIONS: Record<string, number> = { crown: 0, shoulder: 45, sidewall: 90 };
const DIRECTIONS: Record<string, number> = { x: 0, y: 90 };

/** Every film of a layout, unit after unit; a staggered unit's films are spread evenly to the next unit. */
export function filmsOf(layout: RankedLayout): WheelFilm[] {
  const { places, spacing_deg, turn_deg, units, films, staggered, position } = layout;
  if (spacing_deg == null) return (places ?? []).map(({ theta_deg, phi_deg, angle_deg }) => ({ theta_deg, section_deg: phi_deg, angle_deg }));
  const section_deg = POSITIONS[position] ?? Number.parseFloat(position);
  if (!Number.isFinite(section_deg)) return [];
  const apart = staggered === true ? spacing_deg / films.length : 0;
  return Array.from({ length: units }, (_, unit) =>
    films.map((film, k) => ({ theta_deg: (turn_deg ?? 0) + unit * spacing_deg + k * apart, section_deg, angle_deg: DIRECTIONS[film] ?? Number(film) })),
  ).flat();
}

/** The films of a gluing sheet. */
export function filmsOnSheet(films: readonly SheetFilm[]): WheelFilm[] {
  return films.map(({ theta_deg, phi_deg, direction }) => ({ theta_deg, section_deg: phi_deg, angle_deg: DIRECTIONS[direction] ?? Number(direction) }));
}

/** Angle from the contact to a film, -180 to 180 degrees, with the wheel turned so that its own angle `contact_deg` touches down. */
export function apartOf(film: Pick<WheelFilm, "theta_deg">, contact_deg: number): number {
  return turned(film.theta_deg - contact_deg);
}

/** An angle within half a turn, -180 to 180 degrees. */
export function turned(angle_deg: number): number {
  return ((((angle_deg + 180) % 360) + 360) % 360) - 180;
}

/** The tire as it is drawn, mm; of other bodies the reference tire's. */
export interface WheelShape {
  outer_mm: number;
  section_mm: number;
  wall_mm: number;
  bead_deg: number;
}

const REFERENCE: WheelShape = { outer_mm: 50, section_mm: 12.5, wall_mm: 3, bead_deg: 120 };

/** Reads the geometry of a study's document, which is canonical: its scene is inline. */
export function shapeOf(document: Record<string, unknown>): WheelShape {
  const geometry = at(at(document, "scene"), "geometry");
  const number = (key: string, other: number): number => (typeof geometry[key] === "number" ? geometry[key] : other);
  return {
    outer_mm: number("outer_radius_mm", REFERENCE.outer_mm),
    section_mm: number("section_radius_mm", REFERENCE.section_mm),
    wall_mm: number("wall_mm", REFERENCE.wall_mm),
    bead_deg: number("bead_angle_deg", REFERENCE.bead_deg),
  };
}

function at(value: unknown, key: string): Record<string, unknown> {
  const found = typeof value === "object" && value !== null ? (value as Record<string, unknown>)[key] : null;
  return typeof found === "object" && found !== null ? (found as Record<string, unknown>) : {};
}

/** Distance of the inner surface from the axle at a section angle, mm. */
export function innerRadius({ outer_mm, section_mm, wall_mm }: WheelShape, section_deg: number): number {
  return outer_mm - section_mm + (section_mm - wall_mm) * Math.cos((section_deg * Math.PI) / 180);
}

/** Where something at a distance from the axle stands in a picture whose y goes down; 0 degrees is the contact below, positive to the right. */
export function onWheel(radius_mm: number, apart_deg: number): { x: number; y: number } {
  const angle = (apart_deg * Math.PI) / 180;
  return { x: radius_mm * Math.sin(angle), y: radius_mm * Math.cos(angle) };
}
