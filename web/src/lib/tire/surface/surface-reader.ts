/** The wheel's skins as `/surface` sends them: a header in JSON, then arrays of 32-bit floats. */

import type { IndexMap } from "../../../wire.ts";
import type { MapGrid } from "../map/map-grid.ts";

/** Points of one skin, row after row, three numbers each, mm: x in the rolling direction, y along the axle, z upward from the wheel's centre. */
export interface Skin {
  inflated: Float32Array;
  /** From there to the equilibrium at the means. */
  displacement: Float32Array;
}

/** The ground's height over x along its normal; the wheel leans to that by its camber, right-handed about x. */
export interface Ground {
  x_mm: number[];
  z_mm: number[];
  camber_deg: number;
}

/** Skins over angles of the undeformed tire. A whole wheel's last column is its first, 360 degrees on. */
export interface Surface extends MapGrid {
  inner: Skin;
  /** Absent where only the map's sector is known. */
  outer: Skin | null;
  /** Absent where it isn't known. */
  ground: Ground | null;
}

/** The header's fields that are read. */
interface Header {
  rows: number;
  columns: number;
  phi_deg: number[];
  theta_deg: number[];
  ground?: Ground | null;
  arrays: { name: string; components: number; offset: number; count: number }[];
}

const LENGTH_BYTES = 4;
const FLOAT_BYTES = 4;

/** Reads the bytes; throws an Error that says what is wrong with them. */
export function readSurface(bytes: ArrayBuffer): Surface {
  const header = headerOf(bytes);
  const { rows, columns, phi_deg, theta_deg } = header;
  if (phi_deg.length !== rows || theta_deg.length !== columns || rows < 2 || columns < 3) {
    throw new Error("The surface's rows and columns don't fit its angles.");
  }
  const skin = (side: string): Skin => ({
    inflated: closed(arrayOf(bytes, header, `${side}_inflated_mm`), rows, columns),
    displacement: closed(arrayOf(bytes, header, `${side}_displacement_mm`), rows, columns),
  });
  return {
    theta_deg: [...theta_deg, (theta_deg[0] as number) + 360],
    phi_deg,
    inner: skin("inner"),
    outer: skin("outer"),
    ground: header.ground ?? null,
  };
}

/** The sector of the inner skin that the map covers, for services that send no skins; null without its shape. */
export function sectorOf({ theta_deg, phi_deg, shape }: IndexMap): Surface | null {
  if (shape.inflated_mm.length !== theta_deg.length * phi_deg.length) return null;
  const inner = { inflated: Float32Array.from(shape.inflated_mm.flat()), displacement: Float32Array.from(shape.displacement_mm.flat()) };
  return { theta_deg, phi_deg, inner, outer: null, ground: null };
}

/** Whether a surface goes all around. */
export function isWheel({ theta_deg }: MapGrid): boolean {
  return (theta_deg[theta_deg.length - 1] ?? 0) - (theta_deg[0] ?? 0) >= 360;
}

function headerOf(bytes: ArrayBuffer): Header {
  if (bytes.byteLength < LENGTH_BYTES) throw new Error("The surface is empty.");
  const length = new DataView(bytes).getUint32(0, true);
  if (LENGTH_BYTES + length > bytes.byteLength) throw new Error("The surface ends within its header.");
  const text = new TextDecoder().decode(new Uint8Array(bytes, LENGTH_BYTES, length));
  return JSON.parse(text) as Header;
}

function arrayOf(bytes: ArrayBuffer, header: Header, name: string): Float32Array {
  const entry = header.arrays.find((each) => each.name === name);
  if (entry === undefined) throw new Error(`The surface has no ${name}.`);
  if (entry.components !== 3 || entry.count !== header.rows * header.columns) throw new Error(`${name} has another number of points than the surface.`);
  const start = LENGTH_BYTES + new DataView(bytes).getUint32(0, true) + entry.offset;
  const numbers = 3 * entry.count;
  if (start + FLOAT_BYTES * numbers > bytes.byteLength) throw new Error(`The surface ends within ${name}.`);
  const view = new DataView(bytes, start);
  return Float32Array.from({ length: numbers }, (_, k) => view.getFloat32(FLOAT_BYTES * k, true));
}

/** With the first column once more behind the last. */
function closed(points: Float32Array, rows: number, columns: number): Float32Array {
  const wide = new Float32Array(3 * rows * (columns + 1));
  for (let row = 0; row < rows; row += 1) {
    const from = 3 * row * columns;
    wide.set(points.subarray(from, from + 3 * columns), 3 * row * (columns + 1));
    wide.set(points.subarray(from, from + 3), 3 * (row * (columns + 1) + columns));
  }
  return wide;
}
