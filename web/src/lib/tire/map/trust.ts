/** How far a value may be trusted, which says how much colour it gets. */

import { oklabOfRgb, rgbOfOklab, type Rgb } from "../../chart/colour.ts";
import type { Quantity } from "../../route.ts";

/** What a map shows: a layer of a study, or the difference of two. */
export type Layered = Quantity | "difference";

/** What a value is weighed by; null where it isn't known. */
export interface Evidence {
  value: number | null;
  /** Of an index, absolute. */
  error: number | null;
  /** Standard deviation of the strain there. */
  deviation: number | null;
  /** Noise of a film, strain. */
  noise: number | null;
}

/** Of places without a value or without trust, on light and on dark ground. */
export const GREY: Rgb = [150, 150, 150];

/**
 * From 0, grey, to 1, full colour: none up to the bound, all from twice the bound on.
 *
 * A strain and a deviation are bounded by the films' noise. An index is bounded by its own error, and counts no more than the deviation that it is a share of; so is a difference, by
 * the error of the difference. Between films there is no signal to trust.
 */
export function trustOf(quantity: Layered, { value, error, deviation, noise }: Evidence): number {
  if (value === null) return 0;
  switch (quantity) {
    case "strain":
      return above(Math.abs(value), noise);
    case "std":
      return above(value, noise);
    case "error":
      return above(deviation, noise);
    case "index":
    case "total":
      return Math.min(above(value, error), above(deviation, noise));
    case "difference":
      return Math.min(above(Math.abs(value), error), above(deviation, noise));
    case "signal":
      return 0;
  }
}

/** An unknown bound takes no trust away: the legend says that it is unknown. */
export function above(value: number | null, bound: number | null): number {
  if (bound === null || bound <= 0) return 1;
  return value === null ? 0 : Math.min(1, Math.max(0, value / bound - 1));
}

/** A colour with so much of its trust left. */
export function faded(colour: Rgb, trust: number): Rgb {
  if (trust >= 1) return colour;
  if (trust <= 0) return GREY;
  const [from, to] = [oklabOfRgb(GREY), oklabOfRgb(colour)];
  const mix = (k: 0 | 1 | 2): number => from[k] + (to[k] - from[k]) * trust;
  return rgbOfOklab([mix(0), mix(1), mix(2)]);
}
