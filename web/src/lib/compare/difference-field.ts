/** Layers of several studies on one scale, and their differences with the errors of these. */

import { diverging } from "../chart/colour.ts";
import { cornersAt, interpolate, type Corner } from "../tire/map/map-grid.ts";
import type { Field, Scale } from "../tire/map/surface-field.ts";
import { trustOf } from "../tire/map/trust.ts";

/** Fields of one quantity on the widest of their scales, so that a colour means one value in all of them. */
export function onOneScale(fields: readonly Field[]): Field[] {
  const low = Math.min(...fields.map(({ scale }) => scale.low));
  const high = Math.max(...fields.map(({ scale }) => scale.high));
  return fields.map((field) => ({ ...field, scale: { ...field.scale, low, high } }));
}

/** Whether differences of a quantity mean anything: those of errors have no error, and films' signals are no field. */
export function hasDifferences({ quantity }: Pick<Field, "quantity">): boolean {
  return quantity !== "error" && quantity !== "signal" && quantity !== "difference";
}

/**
 * A field minus the baseline's, on its own grid; where the grids differ the baseline is interpolated as its map is.
 *
 * The error of an index' difference is the root of both errors' squares, as if they were independent: meshes err alike, so that it is too large rather than too
 * small. A map has no errors of strains and deviations; there it is what two films of this noise differ by.
 */
export function differenceField(field: Field, base: Field): Field {
  const at = gridPoints(field).map((point) => cornersAt(base, point));
  const from = (values: readonly (number | null)[], k: number): number | null => valueAt(values, at[k] ?? null);
  const noise = larger(field.noise, base.noise);
  const isIndex = field.quantity === "index" || field.quantity === "total";
  const values = field.values.map((value, k) => minus(value, from(base.values, k)));
  const errors = field.values.map((_, k) => {
    if (field.quantity === "index") return rootOfSquares(field.errors[k] ?? null, from(base.errors, k));
    return isIndex || noise === null ? null : Math.SQRT2 * noise;
  });
  // An index is a share of its deviation: where either strain hardly varies, neither is their difference anything.
  const deviations = field.deviations.map((deviation, k) => smaller(deviation, from(base.deviations, k)));
  const shown: Field = { ...field, quantity: "difference", values, errors, deviations, noise: isIndex ? noise : null };
  return { ...shown, scale: scaleOf(shown) };
}

/** Zero in its middle; as far as the differences go that are trusted, or all of them where none is. */
function scaleOf(field: Field): Scale {
  const peak = (isCounted: (k: number) => boolean): number =>
    field.values.reduce<number>((most, value, k) => (value !== null && isCounted(k) ? Math.max(most, Math.abs(value)) : most), 0);
  const evidence = (k: number) => ({
    value: field.values[k] ?? null,
    error: field.errors[k] ?? null,
    deviation: field.deviations[k] ?? null,
    noise: field.noise,
  });
  const high = peak((k) => trustOf("difference", evidence(k)) > 0) || peak(() => true) || 1;
  return { low: -high, high, colour: diverging, unit: field.scale.unit };
}

function gridPoints({ theta_deg, phi_deg }: Field): { theta_deg: number; phi_deg: number }[] {
  return phi_deg.flatMap((phi) => theta_deg.map((theta) => ({ theta_deg: theta, phi_deg: phi })));
}

function valueAt(values: readonly (number | null)[], corners: readonly Corner[] | null): number | null {
  return corners === null ? null : interpolate(values, corners);
}

function minus(a: number | null, b: number | null): number | null {
  return a === null || b === null ? null : a - b;
}

function rootOfSquares(a: number | null, b: number | null): number | null {
  return a === null || b === null ? null : Math.hypot(a, b);
}

function smaller(a: number | null, b: number | null): number | null {
  return a === null || b === null ? null : Math.min(a, b);
}

function larger(a: number | null, b: number | null): number | null {
  return a === null ? b : b === null ? a : Math.max(a, b);
}
