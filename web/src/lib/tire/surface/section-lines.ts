/** Strain and shape at the solved values of one input, as `/sections` sends them, and what lies between. */

import type { Direction } from "../../direction.ts";
import { cornersAt, interpolate, type MapGrid, type SurfacePoint } from "../map/map-grid.ts";
import type { Skin, Surface } from "./surface-reader.ts";
import type { SectionNode, Sections } from "../../../wire.ts";

/** Where a value lies: on a solved one (share 0), or between it and the next. */
export interface Between {
  low: SectionNode;
  high: SectionNode;
  share: number;
}

/** So close to a solved value, as a share of the line's range, is that value. */
const SNAP = 0.006;

/** The solved values about a value; null without any. Values beyond the ends are the ends'. */
export function nodesAbout({ nodes }: Pick<Sections, "nodes">, value: number): Between | null {
  const [first, last] = [nodes[0], nodes[nodes.length - 1]];
  if (first === undefined || last === undefined) return null;
  const near = nodes.find((node) => Math.abs(node.value - value) <= SNAP * (last.value - first.value));
  if (near !== undefined) return { low: near, high: near, share: 0 };
  if (value <= first.value) return { low: first, high: first, share: 0 };
  const at = nodes.findIndex((node) => node.value > value);
  if (at < 1) return { low: last, high: last, share: 0 };
  const [low, high] = [nodes[at - 1] as SectionNode, nodes[at] as SectionNode];
  return { low, high, share: (value - low.value) / (high.value - low.value) };
}

/** Strain over the map there. */
export function strainAt({ low, high, share }: Between, direction: Direction): number[] {
  const [from, to] = [low[`strain_${direction}`], high[`strain_${direction}`]];
  return from.map((value, k) => mixed(value, to[k] ?? value, share));
}

/** The value between the solved ones. */
export function valueAt({ low, high, share }: Between): number {
  return low.value + share * (high.value - low.value);
}

function mixed(from: number, to: number, share: number): number {
  return share === 0 ? from : from + share * (to - from);
}

/** Strain over the solved values at one place, for a plot. */
export function strainOver(line: Sections, place: SurfacePoint, direction: Direction): { value: number; strain: number }[] {
  const corners = cornersAt(line, place);
  if (corners === null) return [];
  return line.nodes.flatMap((node) => {
    const strain = interpolate(node[`strain_${direction}`], corners);
    return strain === null ? [] : [{ value: node.value, strain }];
  });
}

/** The surface as it is there: moved by what the displacement over the map differs from that at the means. Null without a solve at the means. */
export function movedSurface(surface: Surface, line: Sections, { low, high, share }: Between): Surface | null {
  const means = line.nodes.find((node) => node.cut_point)?.displacement_mm;
  const [from, to] = [low.displacement_mm, high.displacement_mm];
  if (means === undefined) return null;
  const change = [0, 1, 2].map((i) => from.map((start, k) => mixed(start[i] ?? 0, to[k]?.[i] ?? 0, share) - (means[k]?.[i] ?? 0)));
  const moved = (skin: Skin): Skin => ({ inflated: skin.inflated, displacement: plus(surface, skin.displacement, line, change) });
  return { ...surface, inner: moved(surface.inner), outer: surface.outer === null ? null : moved(surface.outer) };
}

/** Displacements of a skin with a change that is known over the map, and none beyond. */
function plus(surface: MapGrid, displacement: Float32Array, map: MapGrid, change: number[][]): Float32Array {
  const sum = displacement.slice();
  const columns = surface.theta_deg.length;
  surface.phi_deg.forEach((phi_deg, row) =>
    surface.theta_deg.forEach((theta_deg, column) => {
      const corners = cornersAt(map, { theta_deg, phi_deg });
      if (corners === null) return;
      change.forEach((values, i) => {
        const at = 3 * (row * columns + column) + i;
        sum[at] = (sum[at] as number) + (interpolate(values, corners) ?? 0);
      });
    }),
  );
  return sum;
}

/** Unit of a scene's field by its name, as `mm`; empty where the name has none. */
export function unitOf(vary: string): string {
  const field = vary.replace(/\[\d+\]$/, "");
  const unit = /_(mm|mpa|deg|n|n_per_mm|v)$/.exec(field)?.[1] ?? "";
  return { mm: "mm", mpa: "MPa", deg: "°", n: "N", n_per_mm: "N/mm", v: "V" }[unit] ?? "";
}
