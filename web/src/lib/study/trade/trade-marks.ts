import type { Rung, Trade } from "../../../wire.ts";

/** What accuracy costs, as coordinates of a picture with two logarithmic axes. */

/** Errors below this are drawn there: a logarithm has no zero. */
export const LEAST_ERROR = 1e-5;

/** A point of the plot: time in seconds, error absolute. */
export interface RungMark {
  rung: Rung;
  seconds: number;
  error: number;
}

/** True errors, the rungs without one left out. */
export const trueMarks = (trade: Trade): RungMark[] => marks(trade, (rung) => rung.error_true);

/** Errors that rungs claim, those that claim nothing left out. */
export const claimedMarks = (trade: Trade): RungMark[] => marks(trade, (rung) => rung.error_claimed);

function marks(trade: Trade, errorOf: (rung: Rung) => number | null | undefined): RungMark[] {
  return trade.rungs.flatMap((rung) => {
    const error = errorOf(rung);
    return error == null ? [] : [{ rung, seconds: rung.wall_s, error: Math.max(error, LEAST_ERROR) }];
  });
}

/** True errors on the Pareto front, fastest first. */
export function front(trade: Trade): RungMark[] {
  return trueMarks(trade)
    .filter((mark) => mark.rung.pareto)
    .sort((a, b) => a.seconds - b.seconds);
}

/** The fastest rung that ranks as the reference does; null if none does. */
export function cheapest(trade: Trade): Rung | null {
  const agreeing = trade.rungs.filter((rung) => rung.ranking_agrees);
  return agreeing.reduce<Rung | null>((best, rung) => (best === null || rung.wall_s < best.wall_s ? rung : best), null);
}
