/**
 * Bounds of a layout's errors, from the fields that the service scores its layouts by.
 *
 * J has the derivatives of all readings by contact angle and depth, S the variances of their noise. I = J' S^-1 J is Fisher's information, and the roots of its
 * inverse's diagonal bound the errors of any unbiased estimate (Cramér and Rao).
 */

import type { FieldLoad, FilmFields, FilmPlace } from "../../../wire.ts";
import { curveAt, turnOf, type Turn } from "./film-turn.ts";

/** Pivot over its diagonal below which two unknowns can't be told from each other: rounding of the sums. */
const SINGULAR = 1e-12;
/** An angle known no better than this isn't known: half a turn. */
const BLIND_DEG = 180;
const DEGREES = 360;

/** What one kind of film reads at a load. */
interface KindField {
  signal: Turn;
  /** Its derivative by the depth, 1/mm. */
  slope: Turn;
  /** Its variance over contacts; none where they don't differ. */
  spread: Turn | null;
}

/** Fields with all that doesn't depend on the layout done. */
export interface ReadyFields {
  fields: FilmFields;
  loads: { load: FieldLoad; kinds: KindField[] }[];
}

export interface Bounds {
  worst_angle_deg: number;
  rms_angle_deg: number;
  worst_depth_mm: number;
  /** The contact angle at which the angle's bound is largest, degrees. */
  at_deg: number;
}

/** Bounds at a load, or the contact angle at which the films can't tell. */
export type LoadBounds = { load: FieldLoad } & ({ bounds: Bounds } | { blind_deg: number });

export function readyFields(fields: FilmFields): ReadyFields {
  const loads = fields.loads.map((load) => ({
    load,
    kinds: load.signals.map((signal, k) => {
      const spread = load.variances?.[k];
      return { signal: turnOf(signal), slope: turnOf(load.slopes_per_mm[k] ?? []), spread: spread === undefined ? null : turnOf(spread) };
    }),
  }));
  return { fields, loads };
}

/** The number of a film's kind; null of one that the study has nothing of. */
export function kindOf({ kinds }: FilmFields, film: Pick<FilmPlace, "phi_deg" | "angle_deg">): number | null {
  const index = kinds.findIndex(({ phi_deg, angle_deg }) => phi_deg === film.phi_deg && angle_deg === film.angle_deg);
  return index < 0 ? null : index;
}

/** A layout's bounds at every load; null when a film is of no kind that the study has. */
export function layoutBounds({ fields, loads }: ReadyFields, films: readonly FilmPlace[]): LoadBounds[] | null {
  const kinds = films.map((film) => kindOf(fields, film));
  if (!kinds.every((kind) => kind !== null)) return null;
  return loads.map(({ load, kinds: of }) => {
    const laid = films.map(({ theta_deg }, k) => ({ theta_deg, field: of[kinds[k] ?? 0] }));
    const found = boundsAt(laid, fields.noise);
    return typeof found === "number" ? { load, blind_deg: found } : { load, bounds: found };
  });
}

interface Laid {
  theta_deg: number;
  field: KindField | undefined;
}

/** Over all contact angles, a degree apart; the first angle at which nothing can be told. */
function boundsAt(films: readonly Laid[], noise: FilmFields["noise"]): Bounds | number {
  const bounds: Bounds = { worst_angle_deg: 0, rms_angle_deg: 0, worst_depth_mm: 0, at_deg: 0 };
  let squares = 0;
  for (let contact = 0; contact < DEGREES; contact += 1) {
    const found = deviations(films, noise, contact);
    if (found === null || !(found.angle <= BLIND_DEG && Number.isFinite(found.depth))) return contact;
    squares += found.angle * found.angle;
    if (found.angle > bounds.worst_angle_deg) [bounds.worst_angle_deg, bounds.at_deg] = [found.angle, contact];
    bounds.worst_depth_mm = Math.max(bounds.worst_depth_mm, found.depth);
  }
  bounds.rms_angle_deg = Math.sqrt(squares / DEGREES);
  return bounds;
}

/** Least standard deviations with the contact at an angle; null where one unknown can't be told from the other. */
function deviations(films: readonly Laid[], noise: FilmFields["noise"], contact: number): { angle: number; depth: number } | null {
  let [angles, both, depths] = [0, 0, 0];
  for (const { theta_deg, field } of films) {
    if (field === undefined) return null;
    const apart = theta_deg - contact;
    const { value, slope } = curveAt(field.signal, apart);
    const [byAngle, byDepth] = [-slope, curveAt(field.slope, apart).value];
    const [ofGain, ofPlace] = [noise.gain_std * value, noise.place_std_deg * byAngle];
    const ofContacts = field.spread === null ? 0 : Math.max(0, curveAt(field.spread, apart).value);
    const variance = noise.floor * noise.floor + ofGain * ofGain + ofPlace * ofPlace + ofContacts;
    angles += (byAngle * byAngle) / variance;
    both += (byDepth * byAngle) / variance;
    depths += (byDepth * byDepth) / variance;
  }
  return ofInverse(angles, both, depths);
}

/** Roots of the diagonal of the inverse of a symmetric matrix, by Cholesky's factor. */
function ofInverse(angles: number, both: number, depths: number): { angle: number; depth: number } | null {
  if (!(angles > SINGULAR * angles && Number.isFinite(angles))) return null;
  const first = Math.sqrt(angles);
  const below = both / first;
  const rest = depths - below * below;
  if (!(rest > SINGULAR * depths && Number.isFinite(rest))) return null;
  const second = Math.sqrt(rest);
  const [x, y] = [1 / first, (-below * (1 / first)) / second];
  return { angle: Math.sqrt(x * x + y * y), depth: 1 / second };
}
