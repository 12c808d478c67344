/** The unrolled inner surface as a field of cells: what one choice of direction and quantity shows. */

import type { IndexMap, LocationStrain } from "../../wire.ts";
import { diverging, sequential, type ColourMap } from "../colour.ts";
import type { Direction } from "../direction.ts";
import type { Quantity } from "../route.ts";

/** One layer on the grid, rows by columns, row after row. */
export interface Field {
  theta_deg: readonly number[];
  phi_deg: readonly number[];
  values: readonly (number | null)[];
  errors: readonly (number | null)[];
  status: readonly string[];
  /** Whether the values depend on the status: all but the strain at the means do. */
  judged: boolean;
  scale: Scale;
}

/** How a value becomes a colour. */
export interface Scale {
  low: number;
  high: number;
  colour: ColourMap;
  /** `percent`: indices and their errors; `microstrain`: strains and their deviations. */
  unit: "percent" | "microstrain";
}

/** A cell under the pointer. */
export interface Cell {
  row: number;
  column: number;
}

/** A named place on the surface. */
export interface PlaceMark {
  name: string;
  theta_deg: number;
  phi_deg: number;
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

/** The field of a choice; null when the map has no such layer. */
export function fieldOf(map: IndexMap, direction: Direction, quantity: Quantity, input: number): Field | null {
  const layer = map.layers.find((candidate) => candidate.direction === direction);
  if (layer === undefined) return null;
  // Documents of earlier versions have one error for all inputs.
  const errors = layer.first_order_error?.[input] ?? layer.error;
  const values = quantity === "index" ? layer.first_order[input] : quantity === "error" ? errors : layer[quantity];
  if (values === undefined) return null;
  const { theta_deg, phi_deg } = map;
  const judged = quantity !== "strain";
  const scale = scaleOf(values, quantity);
  return { theta_deg, phi_deg, values, errors, status: layer.status, judged, scale };
}

function scaleOf(values: readonly (number | null)[], quantity: Quantity): Scale {
  // Indices keep one scale for all inputs and directions, so that two maps can be compared by eye.
  if (quantity === "index") return { low: 0, high: 1, colour: sequential, unit: "percent" };
  const peak = values.reduce<number>((most, value) => Math.max(most, Math.abs(value ?? 0)), 0);
  const high = peak > 0 ? peak : 1;
  if (quantity === "strain") return { low: -high, high, colour: diverging, unit: "microstrain" };
  return { low: 0, high, colour: sequential, unit: quantity === "std" ? "microstrain" : "percent" };
}

/** Position of a value on its scale, 0 to 1. */
export function shareOf(scale: Scale, value: number): number {
  return Math.min(1, Math.max(0, (value - scale.low) / (scale.high - scale.low)));
}

/** The cell whose centre is nearest, null outside the surface by more than half a cell. */
export function cellAt(field: Pick<Field, "theta_deg" | "phi_deg">, theta_deg: number, phi_deg: number): Cell | null {
  const column = nearest(field.theta_deg, theta_deg);
  const row = nearest(field.phi_deg, phi_deg);
  return column === null || row === null ? null : { row, column };
}

export function indexOf(field: Pick<Field, "theta_deg">, cell: Cell): number {
  return cell.row * field.theta_deg.length + cell.column;
}

/** Borders between cells: midpoints, and half a cell beyond the ends. */
export function borders(centres: readonly number[]): number[] {
  const first = centres[0] ?? 0;
  const last = centres[centres.length - 1] ?? 0;
  if (centres.length < 2) return [first - 0.5, last + 0.5];
  const inner = centres.slice(1).map((centre, index) => (centre + (centres[index] as number)) / 2);
  const start = inner[0] as number;
  const end = inner[inner.length - 1] as number;
  return [2 * first - start, ...inner, 2 * last - end];
}

/** P1, P2, ... on the crown. */
export function locationMarks(locations: readonly LocationStrain[]): PlaceMark[] {
  return locations.map(({ name, theta_deg }) => ({ name, theta_deg, phi_deg: 0 }));
}

/** The counts of cells by status. */
export function countStatus(status: readonly string[]): Record<string, number> {
  const counts: Record<string, number> = {};
  for (const name of status) counts[name] = (counts[name] ?? 0) + 1;
  return counts;
}

function nearest(centres: readonly number[], value: number): number | null {
  const edges = borders(centres);
  const [low, high] = [edges[0] as number, edges[edges.length - 1] as number];
  if (value < Math.min(low, high) || value > Math.max(low, high)) return null;
  let best = 0;
  centres.forEach((centre, index) => {
    if (Math.abs(centre - value) < Math.abs((centres[best] as number) - value)) best = index;
  });
  return best;
}
