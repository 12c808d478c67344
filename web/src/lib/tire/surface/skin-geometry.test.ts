import assert from "node:assert/strict";
import { test } from "node:test";
import { surfaceBytes, torusPoint } from "./made-up-surface.ts";
import { deformed, dot, normalsOf, placeOn, trianglesOf, unit, type Vec3 } from "./skin-geometry.ts";
import { readSurface } from "./surface-reader.ts";

const wheel = readSurface(surfaceBytes(72, 13));
const gap = (a: Vec3 | null, b: Vec3): number => (a === null ? Infinity : Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));

test("every cell is two triangles of points that exist", () => {
  const corners = trianglesOf(wheel);
  assert.equal(corners.length, 3 * 2 * 72 * 12);
  assert.ok(Math.max(...corners) === 73 * 13 - 1);
});

test("a place is found on the skin, a turn further too", () => {
  assert.ok(gap(placeOn(wheel, wheel.inner.inflated, { theta_deg: 35, phi_deg: 40 }), torusPoint(35, 40)) < 1e-5);
  assert.ok(gap(placeOn(wheel, wheel.inner.inflated, { theta_deg: 300, phi_deg: 0 }), torusPoint(-60, 0)) < 1e-5);
  assert.equal(placeOn(wheel, wheel.inner.inflated, { theta_deg: 0, phi_deg: 130 }), null);
});

test("the displacement counts as often as asked", () => {
  const at = { theta_deg: 0, phi_deg: 0 };
  const still = torusPoint(0, 0);
  assert.ok(gap(placeOn(wheel, deformed(wheel.inner, 3), at), [still[0], still[1], still[2] + 6]) < 1e-5);
});

test("normals point into the cavity", () => {
  const normals = normalsOf(wheel, wheel.inner.inflated);
  for (const [row, column] of [
    [6, 36],
    [3, 0],
    [9, 72],
  ] as const) {
    const k = row * 73 + column;
    const [theta, phi] = [wheel.theta_deg[column] as number, wheel.phi_deg[row] as number];
    const [near, far] = [torusPoint(theta, phi), torusPoint(theta, phi, 1)];
    const inward = unit([near[0] - far[0], near[1] - far[1], near[2] - far[2]]);
    assert.ok(dot([normals[3 * k], normals[3 * k + 1], normals[3 * k + 2]] as Vec3, inward) > 0.999);
  }
});
