import assert from "node:assert/strict";
import { test } from "node:test";
import { residualShare, solveWords } from "./solve-words.ts";

test("a solve is told by its point, stage, iterations and residual", () => {
  const solve = { ordinal: 12, stage: "pressing", share: 0.5, iterations: 14, residual: 3.2e-4 } as const;
  assert.equal(solveWords(solve), "Point 12: pressing from 50 %, iteration 14, residual 3e-4");
  assert.equal(solveWords({ ...solve, stage: "inflating", share: 0, residual: null }), "Point 12: inflating, iteration 14");
});

test("a residual counts by its digits", () => {
  assert.equal(residualShare({ residual: 1e-4 }), 0.5);
  assert.equal(residualShare({ residual: 30 }), 0);
  assert.equal(residualShare({ residual: 1e-12 }), 1);
  assert.equal(residualShare({ residual: null }), 0);
});
