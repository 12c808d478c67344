/**
 * What a layout's films read with the wheel at an angle, and how well the contact is known there.
 *
 * A film this far from the contact reads h(u) of its ring, u = theta - phi, with phi the contact angle. With J the derivatives of all readings by phi and by the
 * depth, and s the noise of each, I = J'J / s^2 is Fisher's information, and the roots of its inverse's diagonal bound the errors (Cramér and Rao), as in the
 * service, whose noise may also grow with the reading.
 */

import type { StrainRing } from "../../wire.ts";
import { apartOf, turned, type WheelFilm } from "./wheel-films.ts";

/** Samples of a ring: one each degree from -180. */
const DEGREES = 360;
/** Two unknowns count as one below this share of the product of their information: rounding of the rings. */
const SINGULAR = 1e-9;

/** Bounds are the same within this: a layout that repeats itself is worst at its first such angle. */
const SAME = 1e-6;

const DIRECTIONS: Record<string, number> = { x: 0, y: 90 };

/** One film's reading. */
export interface Reading {
  film: WheelFilm;
  /** Angle from the contact, degrees. */
  apart_deg: number;
  /** In the unit of the rings. */
  signal: number;
  /** Derivative by the contact angle, 1/degree. */
  by_angle: number;
  /** Derivative by the depth, 1/mm. */
  by_depth: number;
}

/** The ring that a film reads; null where the study stored none. */
export function ringOf(rings: readonly StrainRing[], film: WheelFilm): StrainRing | null {
  const isSame = (ring: StrainRing): boolean =>
    ring.section_deg === film.section_deg && (DIRECTIONS[ring.direction] ?? Number(ring.direction)) === film.angle_deg;
  return rings.find((ring) => isSame(ring) && ring.strain.length === DEGREES && ring.by_depth.length === DEGREES) ?? null;
}

/** Readings of all films, in their order; null where a film has no ring. */
export function readings(films: readonly WheelFilm[], rings: readonly StrainRing[], contact_deg: number): Reading[] | null {
  const all = films.map((film) => {
    const ring = ringOf(rings, film);
    return ring === null ? null : reading(ring, film, apartOf(film, contact_deg));
  });
  return all.every((each) => each !== null) ? all : null;
}

function reading(ring: StrainRing, film: WheelFilm, apart_deg: number): Reading {
  const [signal, slope] = curveAt(ring.strain, apart_deg);
  return { film, apart_deg, signal, by_angle: -slope, by_depth: curveAt(ring.by_depth, apart_deg)[0] };
}

/** A sample by its whole angle. */
const sample = (samples: readonly number[], degree: number): number => samples[(((degree + 180) % DEGREES) + DEGREES) % DEGREES] ?? 0;

/** Value and derivative: between samples on the cubic through the values and slopes at both ends, as in the service. */
function curveAt(samples: readonly number[], angle_deg: number): [value: number, slope: number] {
  const low = Math.floor(angle_deg);
  const t = angle_deg - low;
  const [a, b, p, q] = [sample(samples, low), sample(samples, low + 1), slopeAt(samples, low), slopeAt(samples, low + 1)];
  const [second, third] = [3 * (b - a) - 2 * p - q, 2 * (a - b) + p + q];
  return [a + t * (p + t * (second + t * third)), p + t * (2 * second + 3 * t * third)];
}

/** Central difference of fourth order, 1/degree. */
function slopeAt(samples: readonly number[], degree: number): number {
  const apart = (by: number): number => sample(samples, degree + by) - sample(samples, degree - by);
  return (8 * apart(1) - apart(2)) / 12;
}

/** Least error of the contact angle with the depth unknown, degrees; null where the films can't tell it, as beyond half a turn. */
export function angleBound(all: readonly Reading[], noise: number): number | null {
  const sum = (term: (reading: Reading) => number): number => all.reduce((total, each) => total + term(each), 0);
  const angle = sum(({ by_angle }) => by_angle ** 2);
  const depth = sum(({ by_depth }) => by_depth ** 2);
  const both = sum(({ by_angle, by_depth }) => by_angle * by_depth);
  const determinant = angle * depth - both ** 2;
  if (!(determinant > SINGULAR * angle * depth)) return null;
  const bound = noise * Math.sqrt(depth / determinant);
  return bound <= DEGREES / 2 ? bound : null;
}

/** A contact angle with the bound there. */
interface WorstAngle {
  contact_deg: number;
  bound_deg: number | null;
}

/** The whole contact angle at which the bound is largest, the first one that can't be told at all before others; null without rings. */
export function worstAngle(films: readonly WheelFilm[], rings: readonly StrainRing[], noise: number): WorstAngle | null {
  let worst: WorstAngle | null = null;
  for (let contact_deg = 0; contact_deg < DEGREES; contact_deg += 1) {
    const all = readings(films, rings, contact_deg);
    if (all === null) return null;
    const bound_deg = angleBound(all, noise);
    if (worst === null || (bound_deg ?? Infinity) > (worst.bound_deg ?? Infinity) * (1 + SAME)) worst = { contact_deg, bound_deg };
    if (bound_deg === null) return worst;
  }
  return worst;
}

/** The next whole angle of the wheel by a turn, 0 to 359 degrees. */
export function turnedBy(contact_deg: number, by_deg: number): number {
  return (turned(contact_deg + by_deg) + DEGREES) % DEGREES;
}
