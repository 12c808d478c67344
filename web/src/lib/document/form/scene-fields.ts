/** The number fields of the form: where they stand, their units, the ranges that the service takes and those that are usual. */

import { grouped } from "../../format.ts";
import { RANGES } from "../../../wire.ts";
import { isTable, valueAt } from "../document-values.ts";

export interface NumberField {
  pointer: string;
  label: string;
  /** As the label shows it; empty for plain numbers. */
  unit: string;
  /** What the service takes. */
  low: number;
  high: number;
  /** Of the slider: from, to, step. */
  usual: readonly [number, number, number];
  /** What it is where a document doesn't say it. */
  absent?: number;
}

type Place = keyof typeof RANGES;

function field(place: Place, label: string, unit: string, usual: NumberField["usual"]): NumberField {
  const [low, high] = RANGES[place];
  return { pointer: `/scene/${place}`, label, unit, low, high, usual };
}

export const GEOMETRY: readonly NumberField[] = [
  field("geometry/wall_mm", "Wall thickness", "mm", [1, 6, 0.1]),
  field("geometry/outer_radius_mm", "Outer radius", "mm", [20, 120, 1]),
  field("geometry/section_radius_mm", "Section radius, outside", "mm", [5, 30, 0.5]),
  field("geometry/bead_angle_deg", "Bead angle, from the crown", "degrees", [60, 150, 1]),
];

export const PRESSURE: NumberField = field("pressure/internal_mpa", "Pressure inside", "MPa", [0, 0.4, 0.005]);

const C10 = field("material/c10_mpa", "C10", "MPa", [0.02, 1, 0.002]);
const D1 = field("material/d1_per_mpa", "D1, 2 over the bulk modulus", "1/MPa", [0, 1, 0.01]);

/** What each law of rubber has; those of Ogden are a list, written as text. */
export const LAWS: Readonly<Record<string, { title: string; fields: readonly NumberField[] }>> = {
  "mooney-rivlin": { title: "Mooney-Rivlin", fields: [C10, field("material/c01_mpa", "C01", "MPa", [0, 0.5, 0.002]), D1] },
  "neo-hookean": { title: "neo-Hooke", fields: [C10, D1] },
  yeoh: {
    title: "Yeoh",
    fields: [C10, field("material/c20_mpa", "C20", "MPa", [-0.1, 0.1, 0.001]), field("material/c30_mpa", "C30", "MPa", [-0.1, 0.1, 0.001]), D1],
  },
  ogden: { title: "Ogden, terms as text", fields: [D1] },
};

export const CARCASS: readonly NumberField[] = [
  field("carcass/angle_deg", "Cord angle, to the circumference", "degrees", [0, 90, 1]),
  field("carcass/stiffness_n_per_mm", "Stiffness of each family", "N/mm", [0, 400, 5]),
  field("carcass/position", "Place in the wall, 0 is inside", "", [0, 1, 0.05]),
  field("carcass/compression_ratio", "Stiffness when compressed, share", "", [0, 1, 0.01]),
];

export const FRICTION: NumberField = field("contact/friction", "Friction", "", [0, 1, 0.05]);
export const CAMBER: NumberField = { ...field("ground/camber_deg", "Camber", "degrees", [-30, 30, 1]), absent: 0 };
export const STATION_SPACING: NumberField = field("ground/station_spacing_mm", "Distance of the stations", "mm", [1, 15, 0.5]);
export const LOAD: NumberField = field("ground/load_n", "Force on flat ground", "N", [0, 60, 0.5]);

export const FILM: readonly NumberField[] = [
  field("film/modulus_mpa", "Modulus", "MPa", [1, 4000, 10]),
  field("film/thickness_mm", "Thickness", "mm", [0.01, 0.3, 0.005]),
  field("film/length_mm", "Length", "mm", [1, 30, 0.5]),
  field("film/width_mm", "Width", "mm", [1, 30, 0.5]),
];

/** The depth of each station of a scene; none where a force presses. */
export function depthFields(document: unknown): NumberField[] {
  const depths = valueAt(document, "/scene/ground/depths_mm");
  if (!Array.isArray(depths)) return [];
  // The service says what the section's radius forbids; the range of a number alone stands here.
  const depth = field("ground/depths_mm/*", "", "mm", [0, 3, 0.05]);
  return depths.map((_, index) => ({ ...depth, pointer: `/scene/ground/depths_mm/${index}`, label: `Depth at P${index + 1}` }));
}

/** All number fields that a document has by its scene. */
export function numberFields(document: unknown): NumberField[] {
  const law = valueAt(document, "/scene/material/model");
  const optional = (pointer: string, fields: readonly NumberField[]): readonly NumberField[] => (isTable(valueAt(document, pointer)) ? fields : []);
  const ground = valueAt(document, "/scene/ground/load_n") === undefined ? depthFields(document) : [LOAD];
  return [
    ...GEOMETRY,
    PRESSURE,
    ...(LAWS[String(law)]?.fields ?? []),
    ...optional("/scene/carcass", CARCASS),
    FRICTION,
    CAMBER,
    STATION_SPACING,
    ...ground,
    ...optional("/scene/film", FILM),
  ];
}

/** The slider's ends, wide enough for a value beyond the usual. */
export function sliderRange({ usual: [from, to, step] }: NumberField, value: number): { from: number; to: number; step: number } {
  return { from: Math.min(from, value), to: Math.max(to, value), step };
}

/** The usual range, as the label shows it. */
export function usualWords({ usual: [low, high] }: Pick<NumberField, "usual">): string {
  return rangeWords({ low, high });
}

/** The range that the service takes. */
export function rangeWords({ low, high }: Pick<NumberField, "low" | "high">): string {
  return `${plain(low)} to ${plain(high)}`;
}

/** Powers of ten beyond a million in short, all else in full. */
function plain(value: number): string {
  const power = Math.log10(value);
  if (value > 1e6 && Number.isInteger(power)) return `1e${power}`;
  return value > 0 && value < 1e-4 ? value.toExponential().replace("-", "−") : grouped(String(value).replace("-", "−"));
}

/** What a number box holds; null while it is none. */
export function numberIn(text: string): number | null {
  const value = text.trim() === "" ? Number.NaN : Number(text.trim().replace(",", "."));
  return Number.isFinite(value) ? value : null;
}
