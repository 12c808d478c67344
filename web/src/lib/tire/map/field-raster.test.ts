import assert from "node:assert/strict";
import { test } from "node:test";
import { sequential } from "../../chart/colour.ts";
import type { Rulers } from "./arc-length.ts";
import { rasterOf } from "./field-raster.ts";
import type { Field } from "./surface-field.ts";
import { GREY } from "./trust.ts";

const field: Field = {
  theta_deg: [-1, 1],
  phi_deg: [0, 1],
  quantity: "std",
  values: [0, 1, 2, 4],
  errors: [null, null, null, null],
  deviations: [0, 1, 2, 4],
  status: ["ok", "ok", "ok", "ok"],
  noise: null,
  scale: { low: 0, high: 4, colour: sequential, unit: "microstrain" },
};
const rulers: Rulers = { along: { angles: [-1, 1], marks: [-20, 20] }, across: { angles: [0, 1], marks: [0, 10] }, unit: "mm" };

test("corners are the grid points, the last phi on top, and sides are to scale", () => {
  const { width, height, values } = rasterOf(field, rulers);
  assert.equal(width / height, 4);
  const corner = (row: number, column: number): number => values[row * width + column] as number;
  assert.deepEqual([corner(0, 0), corner(0, width - 1), corner(height - 1, 0), corner(height - 1, width - 1)], [2, 4, 0, 1]);
});

test("pixels have the colour of their value, and grey where it isn't trusted", () => {
  const plain = rasterOf(field, rulers);
  assert.deepEqual([...plain.pixels.slice(4 * (plain.width - 1), 4 * plain.width)], [...sequential(1), 255]);
  const noisy = rasterOf({ ...field, noise: 4 }, rulers);
  assert.deepEqual([...noisy.pixels.slice(0, 4)], [...GREY, 255]);
  assert.ok(noisy.trust.every((trust) => trust === 0));
});
