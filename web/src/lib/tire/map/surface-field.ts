/** The inner surface as a field: what one choice of direction, quantity and input shows. */

import type { IndexMap, LocationStrain, MapLayer, StudyResult } from "../../../wire.ts";
import { diverging, sequential, type ColourMap, type Rgb } from "../../chart/colour.ts";
import type { Direction } from "../../direction.ts";
import type { Quantity } from "../../route.ts";
import { interpolate, type Corner, type MapGrid, type SurfacePoint } from "./map-grid.ts";
import { faded, GREY, trustOf, type Layered } from "./trust.ts";

/** What a map shows. */
export interface Choice {
  direction: Direction;
  quantity: Quantity;
  /** Place of the input in the study's list. */
  input: number;
}

/** One layer on the grid, rows by columns, row after row. */
export interface Field extends MapGrid {
  quantity: Layered;
  values: readonly (number | null)[];
  errors: readonly (number | null)[];
  /** Standard deviation of the strain. */
  deviations: readonly (number | null)[];
  status: readonly string[];
  /** Noise of a film, strain; null where the study names none. */
  noise: number | null;
  scale: Scale;
}

/** How a value becomes a colour. */
export interface Scale {
  low: number;
  high: number;
  colour: ColourMap;
  /** `percent`: indices and their errors; `microstrain`: strains and their deviations; `volt`: films' signals. */
  unit: ScaleUnit;
}

export type ScaleUnit = "percent" | "microstrain" | "volt";

/** What a value is multiplied by to be shown in the unit. */
export const SHOWN_FACTOR: Record<ScaleUnit, number> = { percent: 100, microstrain: 1e6, volt: 1 };

/** A named place on the surface. */
export interface PlaceMark extends SurfacePoint {
  name: string;
}

/** Meridional places, both sides of the crown. */
export const MERIDIONAL_MARKS: readonly { name: string; phi_deg: number }[] = [
  { name: "bead", phi_deg: -120 },
  { name: "sidewall", phi_deg: -90 },
  { name: "shoulder", phi_deg: -45 },
  { name: "crown", phi_deg: 0 },
  { name: "shoulder", phi_deg: 45 },
  { name: "sidewall", phi_deg: 90 },
  { name: "bead", phi_deg: 120 },
];

/** The layer of a direction. */
export function layerOf(map: IndexMap, direction: Direction): MapLayer | null {
  return map.layers.find((candidate) => candidate.direction === direction) ?? null;
}

/** An input's own errors; none of an input that the map doesn't have. */
export function errorsOf(layer: MapLayer, input: number): readonly (number | null)[] {
  return layer.first_order_error[input] ?? [];
}

/** The field of a choice; null when the map has no such layer. */
export function fieldOf(map: IndexMap, { direction, quantity, input }: Choice, noise: number | null): Field | null {
  const layer = layerOf(map, direction);
  if (layer === null) return null;
  const errors = errorsOf(layer, input);
  const values = valuesOf(layer, quantity, input, errors);
  if (values === undefined) return null;
  const { theta_deg, phi_deg } = map;
  const { std: deviations, status } = layer;
  return { theta_deg, phi_deg, quantity, values, errors, deviations, status, noise, scale: scaleOf(values, quantity) };
}

function valuesOf(layer: MapLayer, quantity: Quantity, input: number, errors: readonly (number | null)[]) {
  switch (quantity) {
    case "index":
      return layer.first_order[input];
    case "total":
      return layer.total[input];
    case "error":
      return errors;
    case "std":
    case "strain":
      return layer[quantity];
    case "signal":
      // Films have signals, the skin between them has none.
      return layer.strain.map(() => null);
  }
}

function scaleOf(values: readonly (number | null)[], quantity: Quantity): Scale {
  // Indices keep one scale for all inputs and directions, so that two maps can be compared by eye.
  if (quantity === "index" || quantity === "total") return { low: 0, high: 1, colour: sequential, unit: "percent" };
  if (quantity === "signal") return { low: -1, high: 1, colour: diverging, unit: "volt" };
  const peak = values.reduce<number>((most, value) => Math.max(most, Math.abs(value ?? 0)), 0);
  const high = peak > 0 ? peak : 1;
  if (quantity === "strain") return { low: -high, high, colour: diverging, unit: "microstrain" };
  return { low: 0, high, colour: sequential, unit: quantity === "std" ? "microstrain" : "percent" };
}

/** A field on a scale that is kept. */
export function keptOn(field: Field, ends: readonly [low: number, high: number] | null): Field {
  return ends === null ? field : { ...field, scale: { ...field.scale, low: ends[0], high: ends[1] } };
}

/** Position of a value on its scale, 0 to 1. */
export function shareOf(scale: Scale, value: number): number {
  return Math.min(1, Math.max(0, (value - scale.low) / (scale.high - scale.low)));
}

/** What a place between grid points shows: its value, how far that is trusted, and the colour of both. */
export function shadeAt(field: Field, corners: readonly Corner[]): { value: number | null; trust: number; colour: Rgb } {
  const value = interpolate(field.values, corners);
  if (value === null) return { value, trust: 0, colour: GREY };
  const [error, deviation] = [interpolate(field.errors, corners), interpolate(field.deviations, corners)];
  const trust = trustOf(field.quantity, { value, error, deviation, noise: field.noise });
  return { value, trust, colour: faded(field.scale.colour(shareOf(field.scale, value)), trust) };
}

/** Noise of a film by which the layouts are scored, strain; null where a study scores none or its films are read in volts. */
export function filmNoise(result: StudyResult): number | null {
  if (result.layout_findings != null && result.layout_findings.unit !== "strain") return null;
  return result.layouts[0]?.score.noise_strain ?? null;
}

/** P1, P2, ... on the crown. */
export function locationMarks(locations: readonly LocationStrain[]): PlaceMark[] {
  return locations.map(({ name, theta_deg }) => ({ name, theta_deg, phi_deg: 0 }));
}

/** The counts of grid points by status. */
export function countStatus(status: readonly string[]): Record<string, number> {
  const counts: Record<string, number> = {};
  for (const name of status) counts[name] = (counts[name] ?? 0) + 1;
  return counts;
}
