/** Films that a reader moves: what is done to them, and how they are written down. */

import type { FilmKindPlace, FilmPlace } from "../../../wire.ts";
import { isTable, valueAt, withValue } from "../../document/document-values.ts";
import { apartOf } from "../wheel-films.ts";
import { wrapped } from "./film-turn.ts";

/** Most films that the service scores. */
export const MOST_FILMS = 96;

/** The films, and what they were before each change. */
export interface MovedFilms {
  films: FilmPlace[];
  past: FilmPlace[][];
}

export function begunWith(films: FilmPlace[]): MovedFilms {
  return { films, past: [] };
}

/** After a change, which can be undone. */
export function changed({ films, past }: MovedFilms, next: FilmPlace[]): MovedFilms {
  return { films: next, past: [...past, films] };
}

/** Without the last change. */
export function undone({ films, past }: MovedFilms): MovedFilms {
  return { films: past.at(-1) ?? films, past: past.slice(0, -1) };
}

/** One film somewhere else around the wheel. */
export function movedTo(films: readonly FilmPlace[], index: number, theta_deg: number): FilmPlace[] {
  return films.map((film, k) => (k === index ? { ...film, theta_deg: wrapped(theta_deg) } : film));
}

/** One film of another kind. */
export function turnedInto(films: readonly FilmPlace[], index: number, { phi_deg, angle_deg }: FilmKindPlace): FilmPlace[] {
  return films.map((film, k) => (k === index ? { ...film, phi_deg, angle_deg } : film));
}

export function dropped(films: readonly FilmPlace[], index: number): FilmPlace[] {
  return films.filter((_, k) => k !== index);
}

export function added(films: readonly FilmPlace[], { phi_deg, angle_deg }: FilmKindPlace, theta_deg: number): FilmPlace[] {
  return [...films, { theta_deg: wrapped(theta_deg), phi_deg, angle_deg }];
}

/** The film nearest to an angle of the wheel; null of none. */
export function nearestTo(films: readonly FilmPlace[], theta_deg: number): number | null {
  const distances = films.map((film) => Math.abs(apartOf(film, theta_deg)));
  const least = Math.min(...distances);
  return films.length === 0 ? null : distances.indexOf(least);
}

/** Two films of one kind at one place: the service takes that for a mistake. */
export function areTwice(films: readonly FilmPlace[]): boolean {
  return new Set(films.map(written)).size < films.length;
}

const written = ({ theta_deg, phi_deg, angle_deg }: FilmPlace): string => `${theta_deg}*${phi_deg}*${angle_deg}`;

/** For an address: `0*0*90_30*0*90`, each film by wheel angle, section angle and direction. */
export function filmsText(films: readonly FilmPlace[]): string {
  return films.map(written).join("_");
}

/** From an address; null of anything but films. */
export function filmsFrom(text: string | null): FilmPlace[] | null {
  if (text === null || text === "") return null;
  const films = text.split("_").map((film) => {
    const angles = film.split("*").map((angle) => (angle.trim() === "" ? NaN : Number(angle)));
    const [theta_deg, phi_deg, angle_deg] = angles;
    const isWhole = angles.length === 3 && angles.every((angle) => Math.abs(angle) <= 360);
    return isWhole && theta_deg !== undefined && phi_deg !== undefined && angle_deg !== undefined ? { theta_deg, phi_deg, angle_deg } : null;
  });
  return films.length <= MOST_FILMS && films.every((film) => film !== null) ? films : null;
}

/** What to copy into a study's TOML. */
export function freeLayoutToml(name: string, films: readonly FilmPlace[]): string {
  const lines = films.map(({ theta_deg, phi_deg, angle_deg }) => `  { theta_deg = ${theta_deg}, phi_deg = ${phi_deg}, angle_deg = ${angle_deg} },`);
  return ["[[layouts.free]]", `name = ${JSON.stringify(name)}`, "films = [", ...lines, "]"].join("\n");
}

/** A study's document with one more layout, under a name that no other has. */
export function withFreeLayout(document: unknown, films: readonly FilmPlace[]): unknown {
  if (!isTable(document)) return document;
  const written = valueAt(document, "/layouts/free");
  const free: unknown[] = Array.isArray(written) ? written : [];
  const names = free.map((layout) => valueAt(layout, "/name"));
  let number = 1;
  while (names.includes(nameOf(number))) number += 1;
  return withValue(document, "/layouts/free", [...free, { name: nameOf(number), films }]);
}

/** What a layout that was moved by hand is called. */
export function nameOf(number: number): string {
  return number === 1 ? "by hand" : `by hand ${number}`;
}
