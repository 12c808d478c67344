/** Lines of equal value over a raster. */

import { contours } from "d3-contour";
import { linear } from "../../chart/scales.ts";
import type { Raster } from "./field-raster.ts";
import { SHOWN_FACTOR, type Scale } from "./surface-field.ts";

export interface ContourLine {
  value: number;
  /** Shares of the raster's width and height, from its left and its top. */
  points: [number, number][];
}

/** Every so many pixels of the raster count: lines don't need more. */
const COARSER = 2;
/** About so many. */
const LEVELS = 4;
/** Points of a line, at least: shorter ones are specks. */
const FEWEST = 8;

/** Lines at round values, only where the values are trusted. */
export function contourLines(raster: Raster, scale: Scale): ContourLine[] {
  const factor = SHOWN_FACTOR[scale.unit];
  const levels = linear([scale.low * factor, scale.high * factor], [0, 1])
    .ticks(LEVELS)
    .map((level) => level / factor);
  return linesAt(raster, levels, (trust) => trust > 0);
}

/** Where the values change their sign, trusted or not: near zero no difference can be. */
export function zeroLines(raster: Raster): ContourLine[] {
  return linesAt(raster, [0], () => true);
}

function linesAt(raster: Raster, levels: readonly number[], isTrusted: (trust: number) => boolean): ContourLine[] {
  const [width, height] = [Math.floor(raster.width / COARSER), Math.floor(raster.height / COARSER)];
  const at = (column: number, row: number): number => Math.min(row * COARSER, raster.height - 1) * raster.width + Math.min(column * COARSER, raster.width - 1);
  const values = Array.from({ length: width * height }, (_, k) => raster.values[at(k % width, Math.floor(k / width))] as number);
  const isShown = ([x, y]: [number, number]): boolean => {
    if (x <= 0.5 || y <= 0.5 || x >= width - 0.5 || y >= height - 0.5) return false;
    return isTrusted(raster.trust[at(Math.floor(x), Math.floor(y))] as number);
  };
  return contours()
    .size([width, height])
    .thresholds([...levels])(values)
    .flatMap(({ value, coordinates }) =>
      (coordinates as [number, number][][][])
        .flat()
        .flatMap((ring) => pieces(ring, isShown))
        .map((piece) => ({
          value,
          // A value stands in the middle of its pixel, and the outermost ones on the raster's edge.
          points: piece.map(([x, y]): [number, number] => [(x - 0.5) / (width - 1), (y - 0.5) / (height - 1)]),
        })),
    );
}

/** The parts of a ring that are shown. */
function pieces(ring: [number, number][], isShown: (point: [number, number]) => boolean): [number, number][][] {
  const parts: [number, number][][] = [[]];
  for (const point of ring) {
    if (isShown(point)) (parts[parts.length - 1] as [number, number][]).push(point);
    else parts.push([]);
  }
  return parts.filter((part) => part.length >= FEWEST);
}

/** A label of a line: its value, and where it stands. */
interface ContourLabel {
  value: number;
  at: [number, number];
}

/** Of each value the longest line is labelled, where nothing else stands so near; all in shares of the raster. */
export function contourLabels(lines: readonly ContourLine[], apart: readonly [number, number], taken: readonly [number, number][]): ContourLabel[] {
  const longest = new Map<number, ContourLine>();
  for (const line of lines) {
    const record = longest.get(line.value);
    if (record === undefined || line.points.length > record.points.length) longest.set(line.value, line);
  }
  const labels: ContourLabel[] = [];
  for (const { value, points } of longest.values()) {
    const at = points.find(([x, y]) =>
      [...taken, ...labels.map((label) => label.at)].every((other) => Math.abs(other[0] - x) > apart[0] || Math.abs(other[1] - y) > apart[1]),
    );
    if (at !== undefined) labels.push({ value, at });
  }
  return labels;
}
