import type { Direction } from "../../direction.ts";
import type { WheelShape } from "../../layouts/wheel-films.ts";

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

/** What the paper varied: the depths of its five stations. */
const PAPERS_INPUTS = [0, 1, 2, 3, 4].map((station) => `ground.depths_mm[${station}]`).join();
/** Its tire. */
const PAPERS_TIRE = { outer_mm: 50, section_mm: 12.5, wall_mm: 3 };

/** Whether a study asks what the paper asked, of its tire: only then do the paper's figures belong beside it. */
export function isPapersStudy(inputs: readonly { vary: string }[], shape: WheelShape): boolean {
  const isTire = Object.entries(PAPERS_TIRE).every(([key, value]) => shape[key as keyof typeof PAPERS_TIRE] === value);
  return isTire && inputs.map(({ vary }) => vary).join() === PAPERS_INPUTS;
}
