import type { Direction } from "../types.ts";

/** A direction in words. */
export function directionName(direction: Direction): string {
  return direction === "x" ? "x, circumferential" : "y, meridional";
}
