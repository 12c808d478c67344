import assert from "node:assert/strict";
import { test } from "node:test";
import type { IndexMap } from "../../../wire.ts";
import { rulersOf } from "./arc-length.ts";
import { readingAt } from "./point-reading.ts";

const map: IndexMap = {
  theta_deg: [0, 10],
  phi_deg: [0, 60],
  layers: [
    {
      direction: "x",
      strain: [0.01, 0.02, 0.03, 0.04],
      std: [0.001, 0.001, 0.001, 0.001],
      first_order: [[0.5, 0.7, 0.5, 0.7]],
      error: [0.9, 0.9, 0.9, 0.9],
      first_order_error: [[0.02, 0.04, 0.02, 0.04]],
      total: [[0.5, 0.7, 0.5, 0.7]],
      status: ["ok", "constant", "ok", "ok"],
    },
  ],
  shape: { inflated_mm: [], displacement_mm: [] },
};
const rulers = rulersOf(map, undefined);

test("a place is read in each direction that the map has, each index with its own error", () => {
  const reading = readingAt(map, rulers, { theta_deg: 5, phi_deg: 0 });
  const [x, ...others] = reading?.directions ?? [];
  assert.deepEqual(others, []);
  assert.ok(x !== undefined && Math.abs((x.strain ?? 0) - 0.015) < 1e-12);
  assert.ok(Math.abs((x.indices[0]?.index ?? 0) - 0.6) < 1e-12 && Math.abs((x.indices[0]?.error ?? 0) - 0.03) < 1e-12);
});

test("a grid point gives its own figures and its status, and beyond the map there is none", () => {
  const reading = readingAt(map, rulers, { theta_deg: 10, phi_deg: 0 });
  assert.deepEqual(reading?.directions[0]?.indices, [{ index: 0.7, error: 0.04 }]);
  assert.deepEqual([reading?.along, reading?.across, reading?.directions[0]?.status], [10, 0, "constant"]);
  assert.equal(readingAt(map, rulers, { theta_deg: 11, phi_deg: 0 }), null);
});

test("where the slider stands elsewhere its strains are read", () => {
  const reading = readingAt(map, rulers, { theta_deg: 0, phi_deg: 60 }, { x: [1, 2, 3, 4], y: [] });
  assert.deepEqual([reading?.directions[0]?.strain, reading?.directions[0]?.deviation], [3, 0.001]);
});
