import assert from "node:assert/strict";
import { test } from "node:test";
import type { Estimate, Forecast, StudyCost } from "../../wire.ts";
import { compare } from "./expected-cost.ts";

const cost = { wall_s: 5.04, peak_memory_bytes: 120_000_000 } as StudyCost;
const estimate = (wall_s: Forecast | null) => ({ wall_s, peak_memory_bytes: 100_000_000, reasons: [] as string[] }) as Estimate;

test("what was expected stands beside what it took, with its range", () => {
  assert.deepEqual(compare(estimate({ least: 2, expected: 4.2, most: 70 }), cost), [
    { what: "Wall time", expected: "4.2 s (2.0 s to 1 min 10 s)", took: "5.0 s" },
    { what: "Peak memory", expected: "100 MB", took: "120 MB" },
  ]);
});

test("a range that can't be seen isn't shown, and an unknown time is said to be one", () => {
  assert.equal(compare(estimate({ least: 0.01, expected: 0.02, most: 0.03 }), cost)[0]?.expected, "0.0 s");
  assert.equal(compare(estimate(null), cost)[0]?.expected, "unknown");
});
