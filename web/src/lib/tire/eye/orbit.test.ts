import assert from "node:assert/strict";
import { test } from "node:test";
import { betweenViews, eyeOf, nearer, turnedBy, viewOf, type Orbit } from "./orbit.ts";

const close = (a: readonly number[], b: readonly number[]): boolean => a.every((value, i) => Math.abs(value - (b[i] as number)) < 1e-9);

test("the front looks along the wheel, the side along the axle", () => {
  assert.ok(close(eyeOf(viewOf("front", 50)), [200, 0, 0]));
  assert.ok(close(eyeOf(viewOf("side", 50)), [0, -200, 0]));
});

test("the eye never passes overhead and stays within reach", () => {
  const up = turnedBy(viewOf("side", 50), 10, 500);
  assert.ok(up.elevation_deg < 90 && up.azimuth_deg === 10);
  assert.equal(nearer(viewOf("side", 50), 1e6, 50).distance_mm, 12.5);
  assert.equal(nearer(viewOf("side", 50), 1e-6, 50).distance_mm, 400);
});

test("between two views the way is the shorter one and ends at the second", () => {
  const from: Orbit = { ...viewOf("side", 50), azimuth_deg: 350 };
  const to: Orbit = { ...viewOf("side", 50), azimuth_deg: 20 };
  assert.equal(betweenViews(from, to, 0.5).azimuth_deg, 365);
  assert.ok(close(eyeOf(betweenViews(from, to, 1)), eyeOf(to)));
});
