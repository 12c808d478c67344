/** The trade of films against errors as points to draw. */

import type { TradeAnswer, TradeRow } from "../../wire.ts";
import { short } from "./layout-words.ts";

export interface TradePoint {
  row: TradeRow;
  error: number;
  /** Ends of its error bar. */
  low: number;
  high: number;
  is_picked: boolean;
  title: string;
}

export interface FilmTrade {
  points: TradePoint[];
  /** What is drawn, with its unit. */
  title: string;
  unit: string;
  /** Largest error and most films that are asked for. */
  limit: number | null;
  films: number | null;
}

/** The error that is asked for over the number of films: the angle's, or the force's where that alone has a limit. */
export function filmTrade({ question, rows, picked }: Pick<TradeAnswer, "question" | "rows" | "picked">): FilmTrade {
  const isForce = question.force_n != null && question.angle_deg == null;
  const unit = isForce ? " N" : "°";
  const pointOf = (row: TradeRow, k: number): TradePoint[] => {
    const error = isForce ? row.force_error_n : row.angle_error_deg;
    if (error == null || !(error > 0)) return [];
    const claim = (isForce ? row.force_claim_n : row.angle_claim_deg) ?? 0;
    const title = `${row.words}: ${short(error)}${claim > 0 ? ` ± ${short(claim, 2)}` : ""}${unit}`;
    return [{ row, error, low: Math.max(error - claim, error / 10), high: error + claim, is_picked: k === picked, title }];
  };
  return {
    points: rows.flatMap(pointOf),
    title: isForce ? "force error, N" : "angle error, °",
    unit,
    limit: (isForce ? question.force_n : question.angle_deg) ?? null,
    films: question.films ?? null,
  };
}

/** Range of the errors on a logarithmic scale, limit and error bars within. */
export function errorsOf({ points, limit }: FilmTrade): [number, number] {
  const low = Math.min(...points.map((point) => point.low), limit ?? Infinity);
  const high = Math.max(...points.map((point) => point.high), limit ?? 0);
  return [low / 1.15, high * 1.15];
}
