import assert from "node:assert/strict";
import { test } from "node:test";
import type { IndexMap } from "../../../wire.ts";
import { surfaceBytes, torusPoint } from "./made-up-surface.ts";
import { isWheel, readSurface, sectorOf } from "./surface-reader.ts";

test("both skins are read where they stand, and the wheel closes", () => {
  const surface = readSurface(surfaceBytes(12, 5));
  assert.deepEqual([surface.theta_deg.length, surface.phi_deg.length], [13, 5]);
  assert.equal(surface.theta_deg[12], 180);
  assert.ok(isWheel(surface));
  const at = (points: Float32Array, row: number, column: number) => [...points.subarray(3 * (row * 13 + column), 3 * (row * 13 + column) + 3)];
  assert.deepEqual(at(surface.inner.inflated, 1, 4), torusPoint(-60, -60).map(Math.fround));
  assert.deepEqual(at(surface.outer?.inflated ?? new Float32Array(), 4, 12), torusPoint(-180, 120, 3).map(Math.fround));
  assert.deepEqual(at(surface.inner.displacement, 2, 6), [0, 0, 2]);
  assert.deepEqual(surface.ground?.z_mm, [-38, -38]);
});

test("bytes that end early, or miss an array, are refused with the reason", () => {
  const bytes = surfaceBytes(12, 5);
  assert.throws(() => readSurface(new ArrayBuffer(0)), /empty/);
  assert.throws(() => readSurface(bytes.slice(0, 40)), /within its header/);
  assert.throws(() => readSurface(bytes.slice(0, bytes.byteLength - 4)), /within outer_displacement_mm/);
  const renamed = new Uint8Array(bytes.slice(0));
  const at = new TextDecoder("latin1").decode(renamed).indexOf("inner_inflated_mm");
  renamed[at] = "x".charCodeAt(0);
  assert.throws(() => readSurface(renamed.buffer), /no inner_inflated_mm/);
});

test("a map with its shape is a sector, one without is none", () => {
  const shape = {
    inflated_mm: [
      [0, 0, 1],
      [0, 0, 2],
      [0, 0, 3],
      [0, 0, 4],
    ],
    displacement_mm: [
      [1, 0, 0],
      [2, 0, 0],
      [3, 0, 0],
      [4, 0, 0],
    ],
  };
  const map: IndexMap = { theta_deg: [-1, 1], phi_deg: [0, 1], layers: [], shape };
  const sector = sectorOf(map);
  assert.ok(sector !== null && !isWheel(sector) && sector.outer === null);
  assert.deepEqual([...sector.inner.displacement.subarray(3, 6)], [2, 0, 0]);
  assert.equal(sectorOf({ ...map, shape: { inflated_mm: [], displacement_mm: [] } }), null);
});
