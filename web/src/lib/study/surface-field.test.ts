import assert from "node:assert/strict";
import { test } from "node:test";
import type { IndexMap } from "../../wire.ts";
import { borders, cellAt, countStatus, fieldOf, indexOf, locationMarks, shareOf } from "./surface-field.ts";

const map: IndexMap = {
  theta_deg: [-10, 0, 10],
  phi_deg: [-60, 60],
  layers: [
    {
      direction: "x",
      strain: [-0.02, 0, 0.01, 0, 0, 0],
      std: [0.001, 0.002, null, 0.004, 0, 0],
      first_order: [[0.1, 0.2, null, 0.4, 0.5, 0.6], [0.9, 0.8, null, 0.6, 0.5, 0.4]],
      error: [0.01, 0.01, null, 0.02, 0.01, 0.01],
      status: ["ok", "ok", "constant", "product-form-broken", "ok", "ok"],
    },
  ],
};

test("an index keeps the scale from 0 to 1, a deviation its own", () => {
  const index = fieldOf(map, "x", "index", 1);
  assert.deepEqual(index?.values.slice(0, 3), [0.9, 0.8, null]);
  assert.deepEqual([index?.scale.low, index?.scale.high, index?.scale.unit], [0, 1, "percent"]);
  const deviation = fieldOf(map, "x", "std", 0);
  assert.deepEqual([deviation?.scale.high, deviation?.scale.unit], [0.004, "microstrain"]);
});

test("an index has its own error, and one for all inputs in documents of earlier versions", () => {
  const own = { ...map, layers: map.layers.map((layer) => ({ ...layer, first_order_error: [[0.001], [0.002]] })) };
  assert.deepEqual(fieldOf(own, "x", "index", 1)?.errors, [0.002]);
  assert.deepEqual(fieldOf(own, "x", "error", 0)?.values, [0.001]);
  assert.equal(fieldOf(map, "x", "index", 1)?.errors[0], 0.01);
});

test("signed strain has zero in the middle of its scale", () => {
  const strain = fieldOf(map, "x", "strain", 0);
  assert.ok(strain);
  assert.deepEqual([strain.scale.low, strain.scale.high, strain.judged], [-0.02, 0.02, false]);
  assert.equal(shareOf(strain.scale, 0), 0.5);
  assert.equal(shareOf(strain.scale, 9), 1);
});

test("a direction or an input that the map doesn't have gives no field", () => {
  assert.equal(fieldOf(map, "y", "index", 0), null);
  assert.equal(fieldOf(map, "x", "index", 2), null);
});

test("the nearest cell is found, and none outside the surface", () => {
  const cell = cellAt(map, 6, 10);
  assert.deepEqual(cell, { row: 1, column: 2 });
  assert.equal(indexOf(map, { row: 1, column: 2 }), 5);
  assert.equal(cellAt(map, 15.1, 0), null);
  assert.equal(cellAt(map, 0, -121), null);
});

test("cells meet halfway between their centres", () => {
  assert.deepEqual(borders([-10, 0, 10]), [-15, -5, 5, 15]);
  assert.deepEqual(borders([3]), [2.5, 3.5]);
});

test("locations lie on the crown and statuses are counted", () => {
  const marks = locationMarks([{ name: "P1", theta_deg: -4, strain_x: 0, strain_y: 0, von_mises_mpa: 0 }]);
  assert.deepEqual(marks, [{ name: "P1", theta_deg: -4, phi_deg: 0 }]);
  assert.deepEqual(countStatus(map.layers[0]?.status ?? []), { ok: 4, constant: 1, "product-form-broken": 1 });
});
