import { BufferAttribute, BufferGeometry } from "three";
import { endsOf, markAt, type Ruler, type Rulers } from "../../../../../lib/tire/map/arc-length.ts";
import type { MapGrid } from "../../../../../lib/tire/map/map-grid.ts";
import type { Raster } from "../../../../../lib/tire/map/field-raster.ts";
import { normalsOf, trianglesOf } from "../../../../../lib/tire/surface/skin-geometry.ts";
import type { Skin, Surface } from "../../../../../lib/tire/surface/surface-reader.ts";

/** A grid of points as triangles; `onMap` are the places of its points in the map's picture. */
export function gridGeometry(grid: MapGrid, skin: Skin, onMap: Float32Array | null): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(skin.inflated, 3));
  geometry.setAttribute("moved", new BufferAttribute(skin.displacement, 3));
  geometry.setAttribute("normal", new BufferAttribute(normalsOf(grid, skin.inflated), 3));
  geometry.setAttribute("uv", new BufferAttribute(onMap ?? new Float32Array((2 * skin.inflated.length) / 3), 2));
  geometry.setIndex(new BufferAttribute(trianglesOf(grid), 1));
  return geometry;
}

/** Places of a surface's points in the raster: 0 to 1 over the middles of its outermost pixels, beyond where the map ends. */
export function placesOnMap({ theta_deg, phi_deg }: MapGrid, rulers: Rulers, { width, height }: Pick<Raster, "width" | "height">): Float32Array {
  const across = theta_deg.map((theta) => inPicture(shareOf(rulers.along, theta), width));
  const down = phi_deg.map((phi) => inPicture(1 - shareOf(rulers.across, phi), height));
  return Float32Array.from(down.flatMap((v) => across.flatMap((u) => [u, v])));
}

function shareOf(ruler: Ruler, angle: number): number {
  const [low, high] = endsOf(ruler);
  return (markAt(ruler, angle) - low) / (high - low);
}

/** The picture's edge is the middle of its outermost pixels; what lies beyond stays beyond. */
function inPicture(share: number, pixels: number): number {
  const slack = 1e-6;
  if (share < -slack) return share - 1 / pixels;
  if (share > 1 + slack) return share + 1 / pixels;
  return (0.5 + share * (pixels - 1)) / pixels;
}

/** The wall between both skins along a row: what a cut, or a bead, shows. */
export function wallGeometry({ theta_deg, inner, outer }: Surface, row: number): BufferGeometry | null {
  if (outer === null) return null;
  const columns = theta_deg.length;
  const strip = (of: "inflated" | "displacement"): Float32Array => {
    const points = new Float32Array(6 * columns);
    points.set(inner[of].subarray(3 * row * columns, 3 * (row + 1) * columns));
    points.set(outer[of].subarray(3 * row * columns, 3 * (row + 1) * columns), 3 * columns);
    return points;
  };
  return gridGeometry({ theta_deg, phi_deg: [0, 1] }, { inflated: strip("inflated"), displacement: strip("displacement") }, null);
}

/** Points that stay, as a grid of rows of one length. */
export function stillGeometry(rows: readonly (readonly [number, number, number])[][]): BufferGeometry {
  const columns = rows[0]?.length ?? 0;
  const grid: MapGrid = { theta_deg: Array.from({ length: columns }, (_, k) => k), phi_deg: rows.map((_, k) => k) };
  const inflated = Float32Array.from(rows.flatMap((row) => row.flatMap((point) => [...point])));
  return gridGeometry(grid, { inflated, displacement: new Float32Array(inflated.length) }, null);
}
