import assert from "node:assert/strict";
import { test } from "node:test";
import type { Output, RankedLocation, StudyResult } from "../../wire.ts";
import { paperPercent } from "./paper/paper-table.ts";
import {
  answersLayout,
  bars,
  byRank,
  centreName,
  centreOutput,
  isRanked,
  largest,
  locationNames,
  mdrmGap,
  paperGap,
  productFormBroken,
  scoreOf,
} from "./result-picks.ts";

const output = (location: string, direction: "x" | "y"): Output => ({
  location,
  direction,
  mean: 0.01,
  std: 0.001,
  first_order: [0.1, 0.8, 0.1],
  total: [0.1, 0.8, 0.1],
  method: direction === "x" ? "additive" : "mdrm",
  status: direction === "x" ? "product-form-broken" : "ok",
  error: { mesh: 0.01, quadrature: 0.001, decomposition: 0.009, total: 0.02 },
});
const location = (name: string, rank: number, gsi: number): RankedLocation => ({
  name,
  input: name,
  rank,
  gsi_x_percent: gsi,
  gsi_y_percent: null,
  gsi_x_error_percent: gsi / 20,
  gsi_y_error_percent: null,
  mean_gsi_x_percent: 33,
  mean_gsi_y_percent: 33,
  own_gsi_x_percent: 50,
  own_gsi_y_percent: 50,
  mdrm_gsi_x_percent: gsi / 2,
  mdrm_gsi_y_percent: null,
  rank_x: rank,
  rank_y: rank,
  rank_certain: true,
});
const result = {
  outputs: ["P1", "P2", "P3"].flatMap((name) => [output(name, "x"), output(name, "y")]),
  locations: [location("P1", 2, 12), location("P2", 1, 80), location("P3", 3, 8)],
} as unknown as StudyResult;

test("the middle location is the centre, whatever its name", () => {
  assert.deepEqual(locationNames(result), ["P1", "P2", "P3"]);
  assert.equal(centreName(result), "P2");
  assert.equal(centreOutput(result, "y")?.method, "mdrm");
});

test("bars follow the service's ranks and carry their own error in percentage points", () => {
  assert.deepEqual(bars(result, "x"), [
    { name: "P2", percent: 80, error: 4, mdrm: 40 },
    { name: "P1", percent: 12, error: 0.6, mdrm: 6 },
    { name: "P3", percent: 8, error: 0.4, mdrm: 4 },
  ]);
});

test("places above no depth that varies have no ranking", () => {
  const above = (input: string | null) => ({ ...result, locations: result.locations.map((place) => ({ ...place, input })) });
  assert.equal(isRanked(above("depth")), true);
  assert.equal(isRanked(above(null)), false);
});

test("a broken product form is seen per direction", () => {
  assert.equal(productFormBroken(result, "x"), true);
  assert.equal(productFormBroken(result, "y"), false);
});

test("the largest value of a column skips what doesn't exist", () => {
  assert.equal(largest(byRank(result), (row) => scoreOf(row, "gsi", "x"))?.name, "P2");
  assert.equal(
    largest(byRank(result), (row) => scoreOf(row, "gsi", "y")),
    null,
  );
});

test("the paper's table is largest at P3 in both directions and knows five locations", () => {
  const names = ["P1", "P2", "P3", "P4", "P5"];
  for (const direction of ["x", "y"] as const) {
    assert.equal(
      largest(names, (name) => paperPercent(name, direction)),
      "P3",
    );
  }
  assert.equal(paperPercent("P6", "x"), null);
});

test("columns are compared with the paper's at the location where they differ most", () => {
  // P1 12 - 1.4719, P2 80 - 6.1071, P3 29.9733 - 8; with M-DRM half of each: 40 - 6.1071.
  const gap = paperGap(result, "x");
  assert.ok(gap !== null && Math.abs(gap.valid - 73.8929) < 1e-9 && Math.abs(gap.mdrm - 33.8929) < 1e-9);
  assert.equal(paperGap(result, "y"), null);
});

test("M-DRM's distance from the valid column is held against the error", () => {
  // The error is 2 points; M-DRM has half of each: 40 points away at P2.
  assert.deepEqual(mdrmGap(result, "x"), { points: 40, covered: false });
  const close = { ...result, locations: result.locations.map((row) => ({ ...row, mdrm_gsi_x_percent: row.gsi_x_percent ?? null })) };
  assert.deepEqual(mdrmGap(close, "x"), { points: 0, covered: true });
  assert.equal(mdrmGap(result, "y"), null);
});

test("the answer's layout is found by its rank", () => {
  const layouts = [{ rank: 2 }, { rank: 1 }];
  const withRank = (answer: unknown): StudyResult => ({ ...result, layouts, answer }) as unknown as StudyResult;
  assert.equal(answersLayout(withRank({ layout: { rank: 1 } })), layouts[1]);
  assert.equal(answersLayout(withRank({ layout: null })), null);
  assert.equal(answersLayout(withRank(undefined)), null);
});
