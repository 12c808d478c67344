/** Layouts, films and loads in words. */

import type { CandidateFilm, FilmPlace, LayoutLoad, LoadScore, RankedLayout } from "../../wire.ts";
import { MISSING } from "../format.ts";

/** Where more than one contact in twenty is off by more than this, a layout counts as one that loses the contact, degrees. */
export const LOST_DEG = 20;

/** Below this nothing is left but rounding. */
const NOTHING = 1e-9;

/** A number without needless zeros; all digits before the point. */
export function short(value: number | null | undefined, digits = 3): string {
  if (value == null || !Number.isFinite(value)) return MISSING;
  if (Math.abs(value) < NOTHING) return "0";
  const whole = Math.floor(Math.log10(Math.abs(value))) + 1;
  return String(Number(value.toPrecision(Math.max(digits, whole))));
}

/** `24 films along x and y at the crown, a pair every 30°`. */
export function layoutWords(layout: RankedLayout): string {
  if (layout.spacing_deg == null) return `${layout.name ?? `${layout.units} films`}: ${placesWords(layout.places ?? [])}`;
  const isApart = layout.staggered === true;
  const together = isApart ? 1 : layout.films.length;
  const spacing = short(layout.spacing_deg / (isApart ? layout.films.length : 1));
  return `${countWords(layout)} ${positionWords(layout.position)}, ${TOGETHER[together] ?? `${together} in one place`} every ${spacing}°${first(layout)}`;
}

/** `24 films along x and y`; of films one by one their number alone. */
export function countWords({ film_count, films, spacing_deg, staggered }: RankedLayout): string {
  const count = filmCount(film_count);
  return spacing_deg == null ? count : `${count} along ${listed(films.map(filmWord))}${staggered === true ? " in turn" : ""}`;
}

/** `30 films`. */
export function filmCount(films: number): string {
  return films === 1 ? "1 film" : `${films} films`;
}

/** `30 films`, or `24 films` and `in 12 units` where a unit has more than one. */
export function unitLines({ film_count, units, spacing_deg }: RankedLayout): string[] {
  const isOne = spacing_deg == null || units === film_count;
  return [filmCount(film_count), ...(isOne ? [] : [`in ${units} ${units === 1 ? "unit" : "units"}`])];
}

/** `, the first at 8.75°`, of a layout that is turned from the mark. */
function first({ turn_deg }: RankedLayout): string {
  return turn_deg == null ? "" : `, the first at ${short(turn_deg)}°`;
}

const TOGETHER: Record<number, string> = { 1: "one", 2: "a pair" };

/** Films one by one: `0° x at 0, 30, 60°; 45° x at 90°`. */
export function placesWords(places: FilmPlace[]): string {
  const kinds = new Map<string, number[]>();
  for (const { theta_deg, phi_deg, angle_deg } of places) {
    const kind = `${short(phi_deg)}° ${filmWord(short(angle_deg))}`;
    kinds.set(kind, [...(kinds.get(kind) ?? []), theta_deg]);
  }
  return [...kinds].map(([kind, at]) => `${kind} at ${at.map((theta) => short(theta, 4)).join(", ")}°`).join("; ");
}

/** `x`, `y`, or `45°`. */
export function filmWord(direction: string): string {
  if (direction === "x" || direction === "0") return "x";
  if (direction === "y" || direction === "90") return "y";
  return `${direction}°`;
}

/** `25 × 10`, or `point`. */
export function sizeWord({ length_mm, width_mm }: Pick<CandidateFilm, "length_mm" | "width_mm">): string {
  return length_mm == null || width_mm == null ? "point" : `${short(length_mm)} × ${short(width_mm)}`;
}

/** `Glued films of 25 × 10 mm, read in V.`: what layouts' films are. */
export function filmsWords(size_mm: number[] | null | undefined, unit: string): string {
  const [length_mm, width_mm] = size_mm ?? [];
  const film = unit === "V" ? "Glued films" : "Bare films";
  const size = length_mm == null || width_mm == null ? ", as points" : ` of ${sizeWord({ length_mm, width_mm })} mm`;
  return `${film}${size}, read in ${unit}.`;
}

/** `x+y`, `x+y staggered`: what the films of a unit are. */
export function filmSet(films: string[], staggered = false): string {
  return `${films.map(filmWord).join("+")}${staggered ? " staggered" : ""}`;
}

function positionWords(position: string): string {
  return position.endsWith(" deg") ? `${position.replace(" deg", "°")} from the crown` : `at the ${position}`;
}

function listed(words: string[]): string {
  return words.length < 2 ? words.join("") : `${words.slice(0, -1).join(", ")} and ${words.at(-1) ?? ""}`;
}

/** `0.5 mm (5.05 N)`. */
export function loadWords({ depth_mm, load_n }: Pick<LayoutLoad, "depth_mm" | "load_n">): string {
  if (depth_mm == null) return `${short(load_n)} N`;
  return load_n == null ? `${short(depth_mm)} mm` : `${short(depth_mm)} mm (${short(load_n)} N)`;
}

/** The load whose scores a layout is ranked by. */
export function worstLoad(layout: RankedLayout): LoadScore | null {
  const ranked = JSON.stringify(layout.score);
  return layout.loads.find(({ score }) => JSON.stringify(score) === ranked) ?? null;
}

/** The paper's: six units of x and y around the crown. */
export function isPapers({ units, spacing_deg, position, films, staggered }: RankedLayout): boolean {
  const crossed = films.map(filmWord).sort().join() === "x,y";
  return units === 6 && spacing_deg === 60 && position === "crown" && crossed && staggered !== true;
}

/** Of the layouts with so many films at most, the one whose error is least. */
export function bestOfFew(layouts: RankedLayout[], films: number): RankedLayout | null {
  const error = ({ score }: RankedLayout): number => score.simulated_p95_angle_error_deg ?? Infinity;
  const few = layouts.filter((layout) => layout.film_count <= films && error(layout) < Infinity);
  return few.reduce<RankedLayout | null>((best, layout) => (best === null || error(layout) < error(best) ? layout : best), null);
}

/** A search's layout among the ranked ones. */
export function withPlaces(layouts: RankedLayout[], places: FilmPlace[]): RankedLayout | null {
  const wanted = placesWords(places);
  return layouts.find((layout) => layout.places?.length === places.length && placesWords(layout.places) === wanted) ?? null;
}
