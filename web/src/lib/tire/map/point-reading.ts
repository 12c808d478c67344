/** Everything that a result says of one place, interpolated as the map is. */

import type { IndexMap } from "../../../wire.ts";
import { DIRECTIONS, type Direction } from "../../direction.ts";
import { markAt, type Rulers } from "./arc-length.ts";
import { cornersAt, interpolate, nearest, type SurfacePoint } from "./map-grid.ts";
import { errorsOf, layerOf } from "./surface-field.ts";

/** An index with its own error. */
interface IndexReading {
  index: number | null;
  error: number | null;
}

/** What one direction's strain does there. */
export interface DirectionReading {
  direction: Direction;
  strain: number | null;
  deviation: number | null;
  /** Per input, in the order of the inputs. */
  indices: IndexReading[];
  /** Of the nearest grid point. */
  status: string;
}

export interface PointReading extends SurfacePoint {
  /** Along the crown and across the section, from the contact centre; in the rulers' unit. */
  along: number;
  across: number;
  directions: DirectionReading[];
}

/** The reading of a place; null beyond the map. Other strains than those at the means can be given. */
export function readingAt(map: IndexMap, rulers: Rulers, point: SurfacePoint, strains?: Record<Direction, readonly (number | null)[]>): PointReading | null {
  const corners = cornersAt(map, point);
  if (corners === null) return null;
  const directions = DIRECTIONS.flatMap((direction): DirectionReading[] => {
    const layer = layerOf(map, direction);
    if (layer === null) return [];
    const indices = layer.first_order.map((values, input) => ({
      index: interpolate(values, corners),
      error: interpolate(errorsOf(layer, input), corners),
    }));
    const [strain, deviation] = [interpolate(strains?.[direction] ?? layer.strain, corners), interpolate(layer.std, corners)];
    return [{ direction, strain, deviation, indices, status: layer.status[nearest(corners)] ?? "ok" }];
  });
  return { ...point, along: markAt(rulers.along, point.theta_deg), across: markAt(rulers.across, point.phi_deg), directions };
}
