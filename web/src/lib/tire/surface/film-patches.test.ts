import assert from "node:assert/strict";
import { test } from "node:test";
import type { RankedLayout } from "../../../wire.ts";
import { cornersOfFilm, filmsOf, patchOn } from "./film-patches.ts";
import { surfaceBytes } from "./made-up-surface.ts";
import { placeOn, type Vec3 } from "./skin-geometry.ts";
import { readSurface } from "./surface-reader.ts";

const layout = (change: Partial<RankedLayout>): RankedLayout =>
  ({ rank: 1, units: 4, spacing_deg: 90, position: "shoulder", films: ["x", "y"], score: {}, ...change }) as RankedLayout;

test("a layout's films stand at its angles, staggered ones between", () => {
  const films = filmsOf(layout({}));
  assert.deepEqual(
    films.map(({ theta_deg }) => theta_deg),
    [0, 0, 90, 90, -180, -180, -90, -90],
  );
  assert.deepEqual(
    films.slice(0, 2).map(({ phi_deg, angle_deg }) => [phi_deg, angle_deg]),
    [
      [45, 0],
      [45, 90],
    ],
  );
  const staggered = filmsOf(layout({ staggered: true, position: "30 deg", films: ["x", "45"] }));
  assert.deepEqual(staggered.slice(0, 2), [
    { theta_deg: 0, phi_deg: 30, angle_deg: 0 },
    { theta_deg: 45, phi_deg: 30, angle_deg: 45 },
  ]);
});

test("a layout film by film keeps its places", () => {
  const places = [{ theta_deg: 350, phi_deg: 45, angle_deg: 20 }];
  assert.deepEqual(filmsOf(layout({ spacing_deg: null, places })), [{ theta_deg: -10, phi_deg: 45, angle_deg: 20 }]);
});

test("a film along y is long across", () => {
  const corners = cornersOfFilm([6, 2], 90);
  const spans = ([0, 1] as const).map((k) => Math.max(...corners.map((corner) => corner[k])) - Math.min(...corners.map((corner) => corner[k])));
  assert.ok(Math.abs((spans[0] as number) - 2) < 1e-12 && Math.abs((spans[1] as number) - 6) < 1e-12);
});

test("a patch has its true size on the skin and lies just above it", () => {
  const wheel = readSurface(surfaceBytes(360, 121));
  const film = { theta_deg: 80, phi_deg: 30, angle_deg: 90 };
  const patch = patchOn(wheel, wheel.inner, film, [6, 2], false);
  assert.ok(patch);
  const at = (k: number): Vec3 => [...patch.inflated.subarray(3 * k, 3 * k + 3)] as Vec3;
  const length = (from: number, step: number): number =>
    [0, 1, 2, 3, 4, 5].reduce((sum, i) => sum + Math.hypot(...at(from + (i + 1) * step).map((value, j) => value - (at(from + i * step)[j] as number))), 0);
  // The patch is lifted off a section of 10 mm: its inner side is shorter by that share.
  assert.ok(Math.abs(length(3, 7) - 2) < 0.06, `width ${length(3, 7)}`);
  assert.ok(Math.abs(length(21, 1) - 6) < 0.25, `length ${length(21, 1)}`);
  const skin = placeOn(wheel, wheel.inner.inflated, film);
  assert.ok(skin !== null && Math.abs(Math.hypot(...at(24).map((value, j) => value - (skin[j] as number))) - 0.25) < 1e-3);
  assert.equal(patchOn(wheel, wheel.inner, { ...film, phi_deg: 119.9 }, [6, 2], false), null);
});
