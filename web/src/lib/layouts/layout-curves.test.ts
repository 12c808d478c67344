import assert from "node:assert/strict";
import { test } from "node:test";
import type { LayoutScore, RankedLayout } from "../../wire.ts";
import { curves, errorRange, scoreAt, unitTicks } from "./layout-curves.ts";

function score(p95: number | null, error: number | null = null): LayoutScore {
  const errors = error === null ? null : { simulated_p95_angle_error_deg: error };
  return { noise_strain: 1e-3, simulated_p95_angle_error_deg: p95, error: errors };
}

function layout(units: number, at: LayoutScore, change: Partial<RankedLayout> = {}): RankedLayout {
  return { rank: 1, spacing_deg: 360 / units, units, position: "crown", films: ["x", "y"], film_count: 2 * units, loads: [], score: at, ...change };
}

const LAYOUTS = [
  layout(24, score(0.9, 0.2)),
  layout(6, score(132, 70)),
  layout(12, score(3, 4), { staggered: true }),
  layout(8, score(20), { position: "30 deg" }),
  layout(9, score(null)),
  layout(7, score(5), { spacing_deg: null }),
];

test("a curve for each position and set of films, over the units, without layouts that have none", () => {
  const all = curves(LAYOUTS, "worst");
  const told = all.map(({ position, films, points }) => [position, films, points.map((point) => point.units)]);
  assert.deepEqual(told, [
    ["crown", "x+y", [6, 24]],
    ["crown", "x+y staggered", [12]],
    ["30 deg", "x+y", [8]],
  ]);
  assert.deepEqual(
    all[0]?.points.map((point) => point.is_papers),
    [true, false],
  );
  // No angle is off by more than half a turn, none by less than nothing.
  assert.deepEqual(
    all[0]?.points.map((point) => point.high_deg),
    [180, 1.1],
  );
  assert.equal(all[1]?.points[0]?.low_deg, 0);
});

test("one load in place of the worst", () => {
  const loads = [
    { depth_mm: 1, load_n: 13, score: score(3) },
    { depth_mm: 2, load_n: 32, score: score(2) },
  ];
  const two = layout(12, score(3), { loads });
  assert.equal(curves([two], 1)[0]?.points[0]?.error_deg, 2);
  assert.deepEqual(curves([two], 2), []);
  assert.equal(scoreAt(layout(6, score(3)), 0), null, "no scores");
});

test("the scale goes by 1, 2 and 5 up to half a turn", () => {
  assert.deepEqual(errorRange(curves(LAYOUTS, "worst")), [0.5, 180]);
  assert.deepEqual(errorRange([]), [50, 180]);
});

test("units are written where there is room, one before the others", () => {
  const dense = [24, 4, 5, 6, 7, 6];
  assert.deepEqual(
    unitTicks(dense, 6, (units) => units, 1),
    [4, 5, 6, 7, 24],
  );
  assert.deepEqual(
    unitTicks(dense, 6, (units) => units, 2),
    [4, 6, 24],
  );
  assert.deepEqual(
    unitTicks([], 6, (units) => units, 1),
    [],
  );
});
