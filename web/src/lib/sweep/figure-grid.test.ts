import assert from "node:assert/strict";
import { test } from "node:test";
import type { Comparison, DesignView, LayoutAnswer } from "../../wire.ts";
import { cellOf, designGrid, valueRange } from "./figure-grid.ts";

function design(id: string, set: Record<string, unknown>, state = "done", study: object = {}): DesignView {
  return { ordinal: 0, name: id, set, study: { id, name: id, state, points_done: 0, ...study } } as unknown as DesignView;
}

const comparison = {
  studies: [
    { id: "a", best: "P3", best_certain: true },
    { id: "b", best: null, reason: "no depth varies" },
  ],
  rows: [
    { study: "a", location: "P2", x: { gsi_percent: 1 }, y: {} },
    { study: "a", location: "P3", x: { gsi_percent: 72.34, error_percent: 2.06 }, y: { gsi_percent: 50 } },
  ],
} as unknown as Comparison;

test("two fields make a grid, the first down and the second across, with gaps where no design is", () => {
  const designs = [design("a", { wall: 2, cord: 50 }), design("b", { wall: 2, cord: 60 }), design("c", { wall: 3, cord: 60, kept: 1 })];
  const grid = designGrid(designs);
  assert.deepEqual(
    [grid?.rows, grid?.columns],
    [
      { path: "wall", values: ["2", "3"] },
      { path: "cord", values: ["50", "60"] },
    ],
  );
  assert.deepEqual(
    grid?.designs.map((row) => row.map((each) => each?.name ?? null)),
    [
      ["a", "b"],
      [null, "c"],
    ],
  );
});

test("one field stays a list, and so do three", () => {
  assert.equal(designGrid([design("a", { wall: 2 }), design("b", { wall: 3 })]), null);
  assert.equal(designGrid([design("a", { x: 1, y: 1, z: 1 }), design("b", { x: 2, y: 2, z: 2 })]), null);
});

test("a cell has its figure with its error, or how far it is", () => {
  const none = new Map<string, LayoutAnswer | null>();
  const [a, b] = [design("a", {}), design("b", {})];
  assert.deepEqual(cellOf(a, "answer", comparison, none), { words: "P3", sure: "certain", value: null });
  assert.deepEqual(cellOf(b, "answer", comparison, none), { words: "no best place", sure: "no depth varies", value: null });
  assert.deepEqual(cellOf(a, "index-x", comparison, none), { words: "72.3", sure: "± 2.1", value: 72.34 });
  assert.deepEqual(cellOf(a, "index-y", comparison, none), { words: "50.0", sure: "± ?", value: 50 });
  assert.equal(cellOf(b, "index-x", comparison, none).value, null);
  assert.equal(cellOf(a, "index-x", null, none).words, "…");
  const layouts = new Map([
    ["a", { angle_error_deg: 3.21, error_deg: 0.4 } as LayoutAnswer],
    ["b", null],
  ]);
  assert.deepEqual(cellOf(a, "angle-error", comparison, layouts), { words: "3.2", sure: "± 0.4", value: 3.21 });
  assert.equal(cellOf(b, "angle-error", comparison, layouts).sure, "no layout");
  const running = design("c", {}, "running", { points_done: 3, points_total: 26 });
  assert.deepEqual(cellOf(running, "index-x", comparison, none), { words: "running", sure: "3 of 26 points", value: null });
  assert.equal(cellOf(design("d", {}, "failed", { error: "limit-point" }), "answer", comparison, none).sure, "limit-point");
});

test("colours reach from the least value to the largest", () => {
  const cell = (value: number | null) => ({ words: "", sure: null, value });
  assert.deepEqual(valueRange([cell(3), cell(null), cell(1)]), [1, 3]);
  assert.equal(valueRange([cell(null)]), null);
});
