/** A field as a picture, even in arc length: the map paints it and the tire wears it. */

import type { Rgb } from "../../chart/colour.ts";
import { angleAt, endsOf, type Ruler, type Rulers } from "./arc-length.ts";
import { bracket, cornersOf, type Bracket } from "./map-grid.ts";
import { shadeAt, type Field } from "./surface-field.ts";

export interface Raster {
  width: number;
  height: number;
  /** Red, green, blue, opacity; the first row is the last phi. */
  pixels: Uint8ClampedArray<ArrayBuffer>;
  /** Of the pixels: the field's value, and how far it is trusted. */
  values: Float64Array;
  trust: Float64Array;
}

/** Pixels of a raster: fine enough for 30 pixels between the rows of a map, quick enough to follow a slider. */
const WIDTH = 240;
const MOST_ROWS = 160;

export function rasterOf(field: Field, rulers: Rulers): Raster {
  const [width, height] = sizeOf(rulers);
  const columns = brackets(rulers.along, width);
  const rows = brackets(rulers.across, height).reverse();
  const raster: Raster = {
    width,
    height,
    pixels: new Uint8ClampedArray(4 * width * height),
    values: new Float64Array(width * height),
    trust: new Float64Array(width * height),
  };
  rows.forEach((row, i) =>
    columns.forEach((column, j) => {
      const { value, trust, colour } = shadeAt(field, cornersOf(field.theta_deg.length, row, column));
      put(raster, i * width + j, value, trust, colour);
    }),
  );
  return raster;
}

function put(raster: Raster, at: number, value: number | null, trust: number, [red, green, blue]: Rgb): void {
  raster.pixels.set([red, green, blue, 255], 4 * at);
  raster.values[at] = value ?? Number.NaN;
  raster.trust[at] = trust;
}

function sizeOf({ along, across }: Rulers): [number, number] {
  const [width, height] = [along, across].map((ruler) => {
    const [low, high] = endsOf(ruler);
    return Math.max(high - low, Number.EPSILON);
  }) as [number, number];
  return [WIDTH, Math.max(2, Math.min(MOST_ROWS, Math.round((WIDTH * height) / width)))];
}

/** Where evenly spaced marks, the ends among them, lie between the angles. */
function brackets(ruler: Ruler, count: number): Bracket[] {
  const [low, high] = endsOf(ruler);
  return Array.from({ length: count }, (_, k) => {
    const mark = low + ((high - low) * k) / (count - 1);
    return bracket(ruler.angles, angleAt(ruler, mark)) ?? { at: 0, share: 0 };
  });
}
