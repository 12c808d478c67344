import assert from "node:assert/strict";
import { test } from "node:test";
import type { ComparedIndex, ComparedLocation, ComparedStudy, Comparison } from "../../wire.ts";
import { designAxis, matrixOf, realDifferences, strips } from "./comparison-matrix.ts";

const NOTHING: ComparedIndex = {
  gsi_percent: null,
  error_percent: null,
  difference_percent: null,
  difference_error_percent: null,
  verdict: null,
};

function study(id: string, change: Partial<ComparedStudy> = {}): ComparedStudy {
  return {
    id,
    name: `design ${id}`,
    state: "done",
    reason: null,
    level: "coarse",
    reaction_n: 13,
    std_strain_x: 1e-3,
    std_strain_y: 1e-3,
    best: "P3",
    best_certain: true,
    layout_spacing_deg: 30,
    layout_position: "crown",
    cost: null,
    ...change,
  };
}

function row(id: string, location: string, x: Partial<ComparedIndex>): ComparedLocation {
  return {
    study: id,
    location,
    rank: 1,
    rank_certain: true,
    rank_change: null,
    rank_verdict: null,
    x: { ...NOTHING, ...x },
    y: NOTHING,
  };
}

const comparison: Comparison = {
  baseline: "a",
  studies: [study("a"), study("b", { state: "failed", reason: "it has no equilibrium" }), study("c")],
  rows: [
    row("a", "P10", { gsi_percent: 2, error_percent: 3 }),
    row("a", "P3", { gsi_percent: 70, error_percent: 4 }),
    row("c", "P3", { gsi_percent: 73.5, error_percent: 4, difference_percent: 3.5, difference_error_percent: 1, verdict: "real" }),
    row("c", "P10", { gsi_percent: 2.5, error_percent: 3, difference_percent: 0.5, difference_error_percent: 1, verdict: "noise" }),
  ],
  notes: [],
};

test("designs with a result stand by locations, with their numbers in the sweep", () => {
  const matrix = matrixOf(comparison);
  assert.deepEqual(matrix.locations, ["P3", "P10"]);
  assert.deepEqual(
    matrix.rows.map((entry) => [entry.number, entry.cells.map((cell) => cell?.x.gsi_percent)]),
    [
      [1, [70, 2]],
      [3, [73.5, 2.5]],
    ],
  );
  assert.deepEqual(realDifferences(matrix, "x"), { real: 1, of: 2 });
  assert.deepEqual(realDifferences(matrix, "y"), { real: 0, of: 0 });
});

test("one percentage point is as high in every strip, and bars fit with their errors", () => {
  const drawn = strips(matrixOf(comparison), "x", "index");
  const [p3, p10] = drawn;
  assert.ok(p3 !== undefined && p10 !== undefined);
  assert.equal((p3.high - p3.low).toFixed(9), (p10.high - p10.low).toFixed(9));
  for (const strip of drawn) {
    for (const { value, error } of strip.marks) assert.ok(value - (error ?? 0) >= strip.low && value + (error ?? 0) <= strip.high);
  }
  assert.deepEqual([p3.reference, p10.reference], [70, 2]);
});

test("differences are drawn with errors of their own, the baseline at nothing", () => {
  const [p3] = strips(matrixOf(comparison), "x", "difference");
  assert.deepEqual(
    p3?.marks.map((mark) => [mark.number, mark.value, mark.error, mark.verdict]),
    [
      [1, 0, null, null],
      [3, 3.5, 1, "real"],
    ],
  );
  assert.equal(p3?.reference, 0);
});

test("figures that don't exist leave a strip empty, with an axis all the same", () => {
  for (const strip of strips(matrixOf(comparison), "y", "index")) {
    assert.deepEqual(strip.marks, []);
    assert.ok(strip.high > strip.low && Number.isFinite(strip.high));
  }
  assert.deepEqual(strips(matrixOf({ ...comparison, rows: [] }), "x", "index"), []);
});

test("a single varied path labels its designs, several have numbers", () => {
  const walls = [{ set: { "geometry.wall_mm": 2.5 } }, { set: { "geometry.wall_mm": 3 } }];
  assert.deepEqual(designAxis(walls), { title: "geometry.wall_mm", labels: ["2.5", "3"], every: 1 });
  const two = [{ set: { "geometry.wall_mm": 2.5 } }, { set: { "carcass.angle_deg": 50 } }];
  assert.deepEqual(designAxis(two).labels, ["1", "2"]);
  const many = Array.from({ length: 256 }, (_, index) => ({ set: { a: index } }));
  assert.equal(designAxis(many).every, 5);
});
