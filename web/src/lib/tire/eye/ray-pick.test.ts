import assert from "node:assert/strict";
import { test } from "node:test";
import { surfaceBytes } from "../surface/made-up-surface.ts";
import { pick, type Ray } from "./ray-pick.ts";
import { deformed, placeOn, trianglesOf, unit, minus, type Vec3 } from "../surface/skin-geometry.ts";
import { readSurface } from "../surface/surface-reader.ts";

const wheel = readSurface(surfaceBytes(120, 41));
const triangles = trianglesOf(wheel);
const points = deformed(wheel.inner, 2);
const all = (): boolean => true;
const towards = (origin: Vec3, target: Vec3): Ray => ({ origin, direction: unit(minus(target, origin)) });

test("a place that is looked at from the wheel's centre is picked, though the tire is deformed", () => {
  for (const [theta_deg, phi_deg] of [
    [0, 0],
    [12.4, 3.3],
    [-80.1, -20.7],
    [170, 15],
    [-33.3, 24],
  ] as const) {
    const place = placeOn(wheel, points, { theta_deg, phi_deg });
    assert.ok(place);
    const hit = pick(wheel, points, triangles, towards([0, 0, 0], place), all);
    assert.ok(hit);
    // Triangles are flat and the patch between four points isn't: cells are 3 by 6 degrees.
    assert.ok(Math.abs(hit.theta_deg - theta_deg) < 0.05 && Math.abs(hit.phi_deg - phi_deg) < 0.3, `${hit.theta_deg} ${hit.phi_deg}`);
  }
});

test("a grid point is picked exactly", () => {
  const place = placeOn(wheel, points, { theta_deg: 30, phi_deg: 12 });
  assert.ok(place);
  const hit = pick(wheel, points, triangles, towards([0, 0, 0], place), all);
  assert.ok(hit && Math.abs(hit.theta_deg - 30) < 1e-4 && Math.abs(hit.phi_deg - 12) < 1e-4);
});

test("what is cut away is looked through, and a miss is a miss", () => {
  const ray: Ray = { origin: [0, 100, -30], direction: [0, -1, 0] };
  assert.ok((pick(wheel, points, triangles, ray, all)?.phi_deg ?? 0) > 0);
  const hit = pick(wheel, points, triangles, ray, ([, y]) => y < 0);
  assert.ok(hit !== null && hit.phi_deg < 0 && hit.position[1] < 0);
  assert.equal(pick(wheel, points, triangles, { origin: [0, 100, 0], direction: [0, 1, 0] }, all), null);
});
