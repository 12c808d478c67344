/** Films whose signals a study solved, as patches on the tire: each by itself, with nothing known of the skin between them. */

import type { FilmModel, SignalRow, StudyDetail, StudyResult } from "../../../wire.ts";
import { diverging, type Rgb } from "../../chart/colour.ts";
import type { Direction } from "../../direction.ts";
import { shareOf, type Scale } from "../map/surface-field.ts";
import { above, faded } from "../map/trust.ts";
import { POSITIONS, type PatchSize, type ShownFilm } from "./film-patches.ts";

/** A film so far from the contact, and what it reads. */
export interface SignalFilm {
  position: string;
  /** Wheel angle from the contact, degrees. */
  contact_deg: number;
  /** Of the open circuit, V. */
  volts: number;
  /** Null where it isn't known. */
  error: number | null;
}

/** The films that are shown, all of one model at one load. */
export interface SignalFilms {
  model: FilmModel;
  load_n: number;
  films: SignalFilm[];
  /** Null where the document doesn't say it. */
  size: PatchSize | null;
}

/** The model that is shown: the film as it is glued, where that was solved. */
const MODELS: readonly FilmModel[] = ["coupled", "transfer", "bare"];

/** The study's own films along a direction, over the angles from the contact; null where none was solved there. */
export function signalFilms(result: StudyResult, study: Pick<StudyDetail, "document">, direction: Direction): SignalFilms | null {
  const isShown = (row: SignalRow): boolean => row.tire === "own" && row.over === "contact" && row.direction === direction && row.open_circuit_v != null;
  const rows = (result.signals?.rows ?? []).filter(isShown);
  const model = MODELS.find((each) => rows.some((row) => row.film === each));
  if (model === undefined) return null;
  const films = rows
    .filter((row) => row.film === model && row.position in POSITIONS)
    .map(
      (row): SignalFilm => ({
        position: row.position,
        contact_deg: row.contact_deg,
        volts: row.open_circuit_v ?? 0,
        error: row.error?.open_circuit_v ?? null,
      }),
    );
  return { model, load_n: rows.find((row) => row.film === model)?.load_n ?? 0, films, size: sizeIn(study.document) };
}

/** Zero in its middle, as far as the largest of the films goes. */
export function voltScale(films: readonly SignalFilm[]): Scale {
  const peak = films.reduce((most, { volts }) => Math.max(most, Math.abs(volts)), 0);
  const high = peak > 0 ? peak : 1;
  return { low: -high, high, colour: diverging, unit: "volt" };
}

/** As patches in their colours, which fade to grey where the error exceeds the signal. */
export function signalPatches({ films }: SignalFilms, direction: Direction, scale: Scale): ShownFilm[] {
  return films.map(({ position, contact_deg, volts, error }) => ({
    theta_deg: contact_deg,
    phi_deg: POSITIONS[position] ?? 0,
    angle_deg: direction === "x" ? 0 : 90,
    colour: colourOf(volts, error, scale),
  }));
}

function colourOf(volts: number, error: number | null, scale: Scale): Rgb {
  return faded(scale.colour(shareOf(scale, volts)), above(Math.abs(volts), error));
}

/** Length and width of the film of the signals. */
function sizeIn(document: Record<string, unknown>): PatchSize | null {
  const film = (document.signals as { film?: { length_mm?: unknown; width_mm?: unknown } } | null | undefined)?.film;
  return typeof film?.length_mm === "number" && typeof film.width_mm === "number" ? [film.length_mm, film.width_mm] : null;
}
