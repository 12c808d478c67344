/** What a study finds of kinds of film and numbers of units, as tables to show. */

import type { Knee, LayoutFindings, LayoutLoad, OrderAgreement, StudyResult } from "../../wire.ts";
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

/** Whether a study is one of layouts before all: it has them searched, or a single input, by which locations have no order. */
export function asksForLayouts({ inputs, layouts, layout_findings: found }: Pick<StudyResult, "inputs" | "layouts" | "layout_findings">): boolean {
  return found != null && layouts.length > 0 && (inputs.length === 1 || searched(found));
}

const searched = (found: LayoutFindings): boolean => (found.searches ?? []).length > 0;
