import type { Direction } from "../direction.ts";

/**
 * Table 2 of the paper (Sensors 2025, 25, 4026): first-order indices in percent.
 *
 * P2's two figures are read with four decimals each, as all the others have.
 */


const TABLE_2: Record<string, Record<Direction, number>> = {
  P1: { x: 1.4719, y: 0.0662 },
  P2: { x: 6.1071, y: 9.491 },
  P3: { x: 29.9733, y: 32.1724 },
  P4: { x: 6.6748, y: 10.1924 },
  P5: { x: 1.5767, y: 0.0662 },
};

/** The paper's figure for a location; null for locations that it doesn't have. */
export function paperPercent(location: string, direction: Direction): number | null {
  return TABLE_2[location]?.[direction] ?? null;
}
