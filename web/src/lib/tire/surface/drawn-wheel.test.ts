import assert from "node:assert/strict";
import { test } from "node:test";
import { drawnWheel } from "./drawn-wheel.ts";
import { surfaceBytes, torusPoint } from "./made-up-surface.ts";
import { trianglesOf } from "./skin-geometry.ts";
import { isWheel, readSurface } from "./surface-reader.ts";

const wheel = readSurface(surfaceBytes(24, 49));
const drawn = drawnWheel(wheel, [-45, 45]);

test("within the sector the mesh's own points are drawn, and the wheel stays closed", () => {
  assert.ok(isWheel(drawn));
  assert.deepEqual(
    drawn.theta_deg.filter((theta) => Math.abs(theta) <= 45),
    [-45, -30, -15, 0, 15, 30, 45],
  );
  const [row, column] = [drawn.phi_deg.indexOf(0), drawn.theta_deg.indexOf(15)];
  const k = 3 * (row * drawn.theta_deg.length + column);
  const from = 3 * (wheel.phi_deg.indexOf(0) * wheel.theta_deg.length + wheel.theta_deg.indexOf(15));
  assert.deepEqual([...drawn.inner.inflated.subarray(k, k + 3)], [...wheel.inner.inflated.subarray(from, from + 3)]);
  assert.deepEqual([...drawn.inner.displacement.subarray(k, k + 3)], [0, 0, 2]);
});

test("beyond it the wheel is round, by arcs between the mesh's points", () => {
  const row = drawn.phi_deg.indexOf(0);
  drawn.theta_deg.forEach((theta, column) => {
    const k = 3 * (row * drawn.theta_deg.length + column);
    const off = torusPoint(theta, 0).map((value, i) => value - (drawn.inner.inflated[k + i] as number));
    assert.ok(Math.hypot(...off) < 1e-4, `off by ${off.join()} at ${theta}`);
  });
  assert.ok(drawn.theta_deg.every((theta, k) => k === 0 || theta > (drawn.theta_deg[k - 1] as number)));
});

test("rows are halved until few are left, and crown and beads stay", () => {
  assert.equal(drawn.phi_deg.length, 25);
  assert.deepEqual([drawn.phi_deg[0], drawn.phi_deg[12], drawn.phi_deg[24]], [-120, 0, 120]);
  assert.ok((2 * trianglesOf(drawn).length) / 3 < 10_000);
  assert.equal(drawnWheel(readSurface(surfaceBytes(24, 13)), [-45, 45]).phi_deg.length, 13);
});
