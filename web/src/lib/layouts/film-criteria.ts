/** What a study finds of kinds of film and numbers of units, as tables to show. */

import type { Knee, LayoutLoad, OrderAgreement } from "../../wire.ts";
import { filmSet, short } from "./layout-words.ts";

export interface KneeRow {
  place: string;
  /** One for each load; null where that has none. */
  knees: (Knee | null)[];
}

/** A row for each section angle and set of films, a column for each load. */
export function kneeRows(loads: LayoutLoad[]): KneeRow[] {
  const placeOf = (knee: Knee): string => `${short(knee.section_deg)}°, ${filmSet(knee.films)}`;
  const places = [...new Set(loads.flatMap((load) => load.knees.map(placeOf)))];
  return places.map((place) => ({
    place,
    knees: loads.map((load) => load.knees.find((knee) => placeOf(knee) === place) ?? null),
  }));
}

/** Criteria in their order, and the tau of each two; null of one with itself, and where it isn't known. */
export function tauMatrix(agreement: OrderAgreement[]): { criteria: string[]; tau: (number | null)[][] } {
  const criteria = [...new Set(agreement.flatMap(({ first, second }) => [first, second]))];
  const of = (a: string, b: string): number | null =>
    agreement.find(({ first, second }) => (first === a && second === b) || (first === b && second === a))?.tau ?? null;
  return { criteria, tau: criteria.map((a) => criteria.map((b) => of(a, b))) };
}
