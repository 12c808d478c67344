import assert from "node:assert/strict";
import { test } from "node:test";
import { diverging, sequential } from "../chart/colour.ts";
import type { Field } from "../tire/map/surface-field.ts";
import { trustOf } from "../tire/map/trust.ts";
import { differenceField, hasDifferences, onOneScale } from "./difference-field.ts";

function field(values: (number | null)[], change: Partial<Field> = {}): Field {
  return {
    theta_deg: [0, 10],
    phi_deg: [0, 20],
    quantity: "index",
    values,
    errors: [0.03, 0.03, null, 0.03],
    deviations: [1, 1, 1, 1],
    status: ["ok", "ok", "ok", "ok"],
    noise: 0.1,
    scale: { low: 0, high: 1, colour: sequential, unit: "percent" },
    ...change,
  };
}

test("a difference is taken cell by cell, its error the root of both errors' squares", () => {
  const difference = differenceField(field([0.7, 0.2, 0.5, null]), field([0.5, 0.3, 0.1, 0.1], { errors: [0.04, 0.04, 0.04, 0.04] }));
  assert.deepEqual(
    difference.values.map((value) => (value === null ? null : Number(value.toFixed(9)))),
    [0.2, -0.1, 0.4, null],
  );
  assert.deepEqual(
    difference.errors.map((error) => (error === null ? null : Number(error.toFixed(9)))),
    [0.05, 0.05, null, 0.05],
  );
});

test("the baseline is interpolated where grids differ, and nothing is known beyond it", () => {
  const base = field([0, 1, 0, 1], { theta_deg: [0, 20] });
  const wide = field([0.5, 0.5, 0.5, 0.5], { theta_deg: [5, 30] });
  assert.deepEqual(differenceField(wide, base).values, [0.25, null, 0.25, null]);
});

test("zero is the middle of the scale, which differences within their errors don't stretch", () => {
  const errors = [0.01, 0.9, 0.01, 0.01];
  const { scale } = differenceField(field([0.3, 0.9, 0.3, 0.3], { errors }), field([0.2, 0.1, 0.2, 0.2], { errors }));
  assert.deepEqual([Number(scale.low.toFixed(9)), Number(scale.high.toFixed(9)), scale.colour], [-0.1, 0.1, diverging]);
  assert.equal(differenceField(field([0.3, 0.3, 0.3, 0.3]), field([0.3, 0.3, 0.3, 0.3])).scale.high, 1, "nothing differs");
});

test("a difference is grey up to its error, and where a strain hardly varies", () => {
  const evidence = { value: -0.1, error: 0.1, deviation: 1, noise: 0.1 };
  assert.equal(trustOf("difference", evidence), 0);
  assert.equal(trustOf("difference", { ...evidence, value: -0.2 }), 1);
  const quiet = differenceField(field([0.9, 0.9, 0.9, 0.9]), field([0.1, 0.1, 0.1, 0.1], { deviations: [0.05, 1, 1, 1] }));
  assert.deepEqual(quiet.deviations, [0.05, 1, 1, 1]);
});

test("strains differ from what the noise of two films does, not from errors that a map doesn't have", () => {
  const strain: Partial<Field> = { quantity: "strain", noise: 1e-5 };
  const difference = differenceField(field([1e-3, 0, 0, 0], strain), field([0, 0, 0, 0], { ...strain, noise: null }));
  assert.deepEqual([difference.noise, difference.errors[0]], [null, Math.SQRT2 * 1e-5]);
  assert.deepEqual(
    ["index", "std", "error", "signal"].map((quantity) => hasDifferences({ quantity: quantity as Field["quantity"] })),
    [true, true, false, false],
  );
});

test("one scale holds all fields", () => {
  const scale = (high: number): Partial<Field> => ({ scale: { low: -high, high, colour: diverging, unit: "microstrain" } });
  const together = onOneScale([field([1], scale(2)), field([2], scale(5)), field([3], scale(1))]);
  assert.deepEqual(
    together.map((each) => [each.scale.low, each.scale.high]),
    [
      [-5, 5],
      [-5, 5],
      [-5, 5],
    ],
  );
});
