/** What a study was expected to take, beside what it took. */

import type { Estimate, StudyCost } from "../../wire.ts";
import { bytes, duration } from "../format.ts";

/** What it took in time and memory, by name. */
export const took = (cost: StudyCost): [string, string][] => [
  ["Wall time", duration(cost.wall_s)],
  ["Processor time", duration(cost.cpu_s)],
  ["Peak memory", bytes(cost.peak_memory_bytes)],
];

interface Expectation {
  what: string;
  expected: string;
  took: string;
}

export function compare(estimate: Estimate, cost: StudyCost): Expectation[] {
  return [
    { what: "Wall time", expected: expectedTime(estimate), took: duration(cost.wall_s) },
    { what: "Peak memory", expected: bytes(estimate.peak_memory_bytes), took: bytes(cost.peak_memory_bytes) },
  ];
}

/** A time before it is known, with its range. */
export function expectedTime({ wall_s }: Pick<Estimate, "wall_s">): string {
  if (wall_s == null) return "unknown";
  const expected = duration(wall_s.expected);
  const [least, most] = [duration(wall_s.least), duration(wall_s.most)];
  return least === expected && most === expected ? expected : `${expected} (${least} to ${most})`;
}
