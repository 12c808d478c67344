import assert from "node:assert/strict";
import { test } from "node:test";
import type { StrainRing } from "../../wire.ts";
import type { WheelFilm } from "./wheel-films.ts";
import { angleBound, readings, ringOf, turnedBy, worstAngle } from "./wheel-readings.ts";

const radians = (degrees: number): number => (degrees * Math.PI) / 180;
const angles = Array.from({ length: 360 }, (_, k) => k - 180);

/** Signals that are cosines of the angle from the contact. */
function ring(direction: string, by_depth: (angle: number) => number): StrainRing {
  return { section_deg: 0, direction, depth_mm: 1, strain: angles.map((angle) => Math.cos(radians(angle))), by_depth: angles.map(by_depth) };
}

const film = (theta_deg: number, angle_deg = 0): WheelFilm => ({ theta_deg, section_deg: 0, angle_deg });
const RINGS = [ring("x", () => 0), ring("y", () => 1)];

test("a film reads the ring of its section angle and direction, or none", () => {
  assert.equal(ringOf(RINGS, film(0, 90)), RINGS[1]);
  assert.equal(ringOf(RINGS, film(0, 45)), null);
  assert.equal(ringOf(RINGS, { ...film(0), section_deg: 45 }), null);
  assert.equal(readings([film(0), film(0, 45)], RINGS, 0), null);
});

test("readings follow the wheel, between samples too", () => {
  const [at] = readings([film(90)], RINGS, 30) ?? [];
  assert.ok(Math.abs((at?.signal ?? 0) - 0.5) < 1e-12);
  // dh/dphi = -dh/du = sin u, per degree.
  assert.ok(Math.abs((at?.by_angle ?? 0) - radians(1) * Math.sin(radians(60))) < 1e-9);
  const [half] = readings([film(60.5)], RINGS, 0) ?? [];
  assert.ok(Math.abs((half?.signal ?? 0) - Math.cos(radians(60.5))) < 1e-4);
});

test("the bound of two unknowns: one film tells the angle, another the depth alone", () => {
  // At a quarter turn x tells sin 90 of the angle and nothing of the depth; y above the contact tells the depth alone.
  const bound = angleBound(readings([film(90), film(0, 90)], RINGS, 0) ?? [], 0.01);
  assert.ok(Math.abs((bound ?? 0) - 0.01 / radians(1)) < 1e-8);
  assert.equal(angleBound(readings([film(90)], RINGS, 0) ?? [], 0.01), null, "one film can't tell two unknowns");
});

test("the worst angle is where the film that tells the angle is blind", () => {
  // Never both: y tells the depth everywhere, x the angle but above the contact and opposite.
  const worst = worstAngle([film(40), film(40, 90)], RINGS, 0.001);
  assert.deepEqual(worst, { contact_deg: 40, bound_deg: null });
  assert.equal(worstAngle([film(0, 45)], RINGS, 0.001), null);
});

test("the wheel turns on over a whole turn", () => {
  assert.equal(turnedBy(359, 1), 0);
  assert.equal(turnedBy(0, -5), 355);
});
