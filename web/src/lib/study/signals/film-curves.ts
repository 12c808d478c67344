/** Films' readings as curves to draw: a panel for each tire and direction, a curve for each position and model of the film. */

import { type Ends, padded } from "../../chart/scales.ts";
import type { SignalAxis, SignalRow } from "../../../wire.ts";

/** Models that are drawn; what a transfer gives lies on the coupled film's curve. */
export const DRAWN = ["coupled", "bare"] as const;
export type Drawn = (typeof DRAWN)[number];

interface FilmPoint {
  /** Load, pressure or contact angle. */
  at: number;
  /** Of the open circuit, V. */
  volts: number;
  /** Null where it isn't known. */
  error: number | null;
}

export interface FilmCurve {
  position: string;
  film: Drawn;
  points: FilmPoint[];
}

export interface Panel {
  tire: string;
  direction: string;
  over: SignalAxis;
  curves: FilmCurve[];
  /** Ends of the scale along the curves. */
  range: Ends;
  /** Ends of the voltage's scale, for each model. */
  volts: Record<Drawn, Ends>;
}

/** A panel for each tire, direction and axis, in the order of the rows. */
export function panels(rows: SignalRow[], axes: readonly SignalAxis[]): Panel[] {
  const keys = different(rows.map((row) => `${row.direction}\n${row.tire}`)).map((key) => key.split("\n"));
  return keys.flatMap(([direction = "", ...tire]) =>
    axes.map((over) => {
      const of = (row: SignalRow): boolean => row.tire === tire.join("\n") && row.direction === direction && row.over === over;
      return panel(rows.filter(of), tire.join("\n"), direction, over);
    }),
  );
}

function panel(rows: SignalRow[], tire: string, direction: string, over: SignalAxis): Panel {
  const curves = different(rows.map((row) => row.position)).flatMap((position) =>
    DRAWN.map((film) => ({
      position,
      film,
      points: pointsOf(rows.filter((row) => row.position === position && row.film === film)),
    })),
  );
  const ends = (film: Drawn): Ends => padded([0, ...curves.filter((curve) => curve.film === film).flatMap((curve) => curve.points.flatMap(endsOf))]);
  return {
    tire,
    direction,
    over,
    curves: curves.filter((curve) => curve.points.length > 0),
    range: padded(rows.map(placeOf)),
    volts: { bare: ends("bare"), coupled: ends("coupled") },
  };
}

/** Those that have a voltage, in order. */
function pointsOf(rows: SignalRow[]): FilmPoint[] {
  const points = rows.flatMap((row) =>
    row.open_circuit_v == null ? [] : [{ at: placeOf(row), volts: row.open_circuit_v, error: row.error?.open_circuit_v ?? null }],
  );
  return points.sort((a, b) => a.at - b.at);
}

const endsOf = ({ volts, error }: FilmPoint): number[] => [volts - (error ?? 0), volts + (error ?? 0)];

function placeOf(row: SignalRow): number {
  switch (row.over) {
    case "load":
      return row.load_n;
    case "pressure":
      return row.pressure_mpa;
    case "contact":
      return row.contact_deg;
  }
}

export function different<T>(values: T[]): T[] {
  return [...new Set(values)];
}
