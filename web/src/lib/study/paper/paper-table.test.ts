import assert from "node:assert/strict";
import { test } from "node:test";
import { isPapersStudy, paperPercent } from "./paper-table.ts";

const SHAPE = { outer_mm: 50, section_mm: 12.5, wall_mm: 3, bead_deg: 120 };
const INPUTS = [0, 1, 2, 3, 4].map((station) => ({ vary: `ground.depths_mm[${station}]` }));

test("a study is the paper's by its five depths and its tire", () => {
  assert.equal(isPapersStudy(INPUTS, SHAPE), true);
  assert.equal(isPapersStudy(INPUTS.slice(1), SHAPE), false);
  assert.equal(isPapersStudy(INPUTS, { ...SHAPE, wall_mm: 5 }), false);
});

test("Table 2 has P1 to P5 alone", () => {
  assert.equal(paperPercent("P3", "x"), 29.9733);
  assert.equal(paperPercent("P6", "x"), null);
});
