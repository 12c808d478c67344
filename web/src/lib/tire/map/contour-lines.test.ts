import assert from "node:assert/strict";
import { test } from "node:test";
import { sequential } from "../../chart/colour.ts";
import { contourLabels, contourLines } from "./contour-lines.ts";
import type { Raster } from "./field-raster.ts";
import type { Scale } from "./surface-field.ts";

const [width, height] = [80, 40];
const scale: Scale = { low: 0, high: 1, colour: sequential, unit: "percent" };
/** A ramp from left to right, trusted on its right half. */
const ramp = (trusted: (column: number) => boolean): Raster => {
  const columns = Array.from({ length: width * height }, (_, k) => k % width);
  return {
    width,
    height,
    pixels: new Uint8ClampedArray(0),
    values: Float64Array.from(columns, (column) => column / (width - 1)),
    trust: Float64Array.from(columns, (column) => (trusted(column) ? 1 : 0)),
  };
};

test("lines of a ramp stand upright where the value is theirs", () => {
  const lines = contourLines(
    ramp(() => true),
    scale,
  );
  assert.deepEqual(
    lines.map(({ value }) => value),
    [0.2, 0.4, 0.6, 0.8],
  );
  // Half a coarse pixel: the picture has 40 columns of them.
  for (const { value, points } of lines) for (const [x] of points) assert.ok(Math.abs(x - value) < 1 / 40, `${x} for ${value}`);
});

test("no line runs where nothing is trusted", () => {
  const values = contourLines(
    ramp((column) => column >= width / 2),
    scale,
  ).map(({ value }) => value);
  assert.deepEqual(values, [0.6, 0.8]);
});

test("one line of each value is labelled, and none over another label or a mark", () => {
  const line = (value: number, xs: number[]) => ({ value, points: xs.map((x): [number, number] => [x, 0.5]) });
  const labels = contourLabels(
    [line(1, [0.1]), line(1, [0.5, 0.6]), line(2, [0.52, 0.55, 0.7]), line(3, [0.51]), line(4, [0.9, 0.3])],
    [0.1, 0.1],
    [[0.95, 0.5]],
  );
  assert.deepEqual(labels, [
    { value: 1, at: [0.5, 0.5] },
    { value: 2, at: [0.7, 0.5] },
    { value: 4, at: [0.3, 0.5] },
  ]);
});
