import assert from "node:assert/strict";
import { test } from "node:test";
import type { ModelOutput } from "../../wire.ts";
import { indexBars, pointsText, standing } from "./own-analysis.ts";

const NOTHING = { mean: null, variance: null, second_order: null, reason: null, mdrm_first_order: null, mdrm_total: null };
const output: ModelOutput = {
  ...NOTHING,
  name: "y",
  status: "ok",
  method: "corrected",
  first_order: [0.25, 0.5],
  total: [0.5, 0.625],
  error: { by_input: [0.125, 0.0625], floor: 0 },
};

test("the largest index comes first, with its error and its total", () => {
  assert.deepEqual(indexBars(["a", "b"], output), [
    { name: "b", percent: 50, error: 6.25, total: 62.5 },
    { name: "a", percent: 25, error: 12.5, total: 50 },
  ]);
  assert.deepEqual(indexBars(["a", "b"], { ...output, first_order: null }), []);
  const names = Array.from({ length: 30 }, (_, k) => `x${k}`);
  assert.equal(indexBars(names, { ...output, first_order: names.map(() => 1 / 30) }).length, 20);
  assert.equal(indexBars(["a", "b"], { ...output, error: { by_input: null, floor: 0 } })[0]?.error, null);
});

test("points are saved with all their digits", () => {
  const text = pointsText({ inputs: ["a", "b, mm"], points: { ids: [3], rows: [[0.1, 1 / 3]] } });
  assert.equal(text, 'id,a,"b, mm"\n3,0.1,0.3333333333333333\n');
});

test("how far it is", () => {
  assert.equal(standing({ evaluations: 0, wanted: 14, outputs: [] }), "14 points are to be run first.");
  assert.equal(standing({ evaluations: 14, wanted: 1, outputs: [output] }), "Of 14 runs; 1 point is asked for to be surer.");
  assert.equal(standing({ evaluations: 15, wanted: 0, outputs: [output] }), "Of 15 runs; no more are asked for.");
});
