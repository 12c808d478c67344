/** The two directions of strain on the inner surface; the service sends them as texts. */

export const DIRECTIONS = ["x", "y"] as const;
export type Direction = (typeof DIRECTIONS)[number];

/** A direction in words. */
export function directionName(direction: Direction): string {
  return direction === "x" ? "x, circumferential" : "y, meridional";
}
