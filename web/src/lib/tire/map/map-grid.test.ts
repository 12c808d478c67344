import assert from "node:assert/strict";
import { test } from "node:test";
import { bracket, cornersAt, interpolate, stepped } from "./map-grid.ts";

const grid = { theta_deg: [-10, 0, 20], phi_deg: [-60, 60] };
const at = (theta_deg: number, phi_deg: number) => cornersAt(grid, { theta_deg, phi_deg });

test("a value is found between the points of an uneven axis, and not beyond its ends", () => {
  assert.deepEqual(bracket(grid.theta_deg, 5), { at: 1, share: 0.25 });
  assert.deepEqual(bracket(grid.theta_deg, 20), { at: 1, share: 1 });
  assert.equal(bracket(grid.theta_deg, 20.1), null);
  assert.equal(bracket(grid.theta_deg, Number.NaN), null);
  assert.equal(bracket([], 0), null);
});

test("a bilinear field is met exactly everywhere, and a grid point to the bit", () => {
  const field = (theta: number, phi: number) => 3 + 0.5 * theta - 0.25 * phi + 0.125 * theta * phi;
  const values = grid.phi_deg.flatMap((phi) => grid.theta_deg.map((theta) => field(theta, phi)));
  for (const [theta, phi] of [
    [-7, 11],
    [3, -42],
    [19, 59],
  ] as const) {
    const corners = at(theta, phi);
    assert.ok(corners);
    assert.ok(Math.abs((interpolate(values, corners) ?? NaN) - field(theta, phi)) < 1e-12);
  }
  assert.deepEqual(at(0, 60), [{ index: 4, weight: 1 }]);
});

test("beside a point without a value the nearest one counts alone", () => {
  const values = [1, null, 3, 4, 5, 6];
  assert.equal(interpolate(values, at(-8, -50) ?? []), 1);
  assert.equal(interpolate(values, at(-1, -50) ?? []), null);
  // Where the missing one doesn't count, nothing is missing.
  assert.equal(interpolate(values, at(-10, 0) ?? []), 2.5);
});

test("keys step over grid points and stay on the grid", () => {
  assert.deepEqual(stepped(grid, { theta_deg: 1, phi_deg: 50 }, 1, 0), { theta_deg: 20, phi_deg: 60 });
  assert.deepEqual(stepped(grid, { theta_deg: 20, phi_deg: 60 }, 5, 5), { theta_deg: 20, phi_deg: 60 });
});
