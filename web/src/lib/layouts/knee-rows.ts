/** What a study finds of numbers of units, as a table to show. */

import type { Knee, LayoutLoad } from "../../wire.ts";
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
