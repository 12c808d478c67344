import assert from "node:assert/strict";
import { test } from "node:test";
import { angleAt, endsOf, markAt, rulersOf } from "./arc-length.ts";

const DEGREE = Math.PI / 180;
const [RADIUS, SECTION] = [40, 10];
const grid = { theta_deg: [-45, -20, 0, 15, 45], phi_deg: [-120, -60, 0, 60, 120] };
/** A torus whose arcs are known. */
const inflated_mm = grid.phi_deg.flatMap((phi) =>
  grid.theta_deg.map((theta) => {
    const reach = RADIUS - SECTION + SECTION * Math.cos(phi * DEGREE);
    return [reach * Math.sin(theta * DEGREE), SECTION * Math.sin(phi * DEGREE), -reach * Math.cos(theta * DEGREE)];
  }),
);
const rulers = rulersOf(grid, { inflated_mm, displacement_mm: [] });

test("lengths along even circles are those of their arcs", () => {
  assert.equal(rulers.unit, "mm");
  const [low, high] = endsOf(rulers.across);
  // Chords of 60 degrees are 4.5 % too short; the turn between them tells the circle exactly.
  assert.ok(Math.abs(high - SECTION * 120 * DEGREE) < 1e-9 && Math.abs(low + high) < 1e-9);
  assert.ok(Math.abs(markAt(rulers.across, 30) - SECTION * 30 * DEGREE) < 1e-9);
});

test("uneven columns come close, and zero is the contact centre", () => {
  const [low, high] = endsOf(rulers.along);
  assert.ok(Math.abs(high - low - RADIUS * 90 * DEGREE) < 0.01 * RADIUS);
  assert.equal(markAt(rulers.along, 0), 0);
});

test("marks lead back to their angles, beyond the ends too", () => {
  for (const angle of [-60, -45, -3, 0, 44, 70]) assert.ok(Math.abs(angleAt(rulers.along, markAt(rulers.along, angle)) - angle) < 1e-9);
});

test("without a shape the marks are the angles themselves", () => {
  const plain = rulersOf(grid, undefined);
  assert.equal(plain.unit, "°");
  assert.equal(markAt(plain.along, 7), 7);
});
