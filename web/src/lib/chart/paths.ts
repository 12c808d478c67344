/** Lines of a chart as paths of an SVG. */

export type Point = readonly [x: number, y: number];

/** Straight from point to point. */
export function linePath(points: readonly Point[]): string {
  return points.length === 0 ? "" : `M${points.map(([x, y]) => `${short(x)} ${short(y)}`).join("L")}`;
}

/** The same, and back to the first. */
export function closedPath(points: readonly Point[]): string {
  return points.length === 0 ? "" : `${linePath(points)}Z`;
}

/** A tenth of a pixel isn't seen. */
const short = (value: number): number => Math.round(10 * value) / 10;
