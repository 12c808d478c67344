import assert from "node:assert/strict";
import { test } from "node:test";
import type { ForceError, RankedLayout } from "../../wire.ts";
import { bestKnown, knownForces, rangeByDrift, untoldAxes } from "./known-forces.ts";

const trial = (rmse_n: number) => ({ rmse_n, nrmse_percent: 5, r2: 0.9, coverage: 0.95 });

function force(axis: string, rmse: number, useful = true): ForceError {
  return {
    axis,
    chosen: useful ? "gpr" : "mean",
    features: "raw",
    useful,
    splits: [],
    leak: null,
    fresh: trial(rmse),
    in_contact: trial(1.2 * rmse),
    dead: null,
    askew: { std_deg: 3, error: trial(2 * rmse) },
    worst_contact: null,
  };
}

function layout(rank: number, film_count: number, force_error?: ForceError[]): RankedLayout {
  return { rank, units: film_count / 2, film_count, position: "crown", films: ["x", "y"], force_error } as unknown as RankedLayout;
}

const layouts = [
  layout(1, 48, [force("fx", 0.9, false), force("fz", 1.4)]),
  layout(2, 24, [force("fx", 0.9, false), force("fz", 1.8)]),
  layout(3, 12, [force("fx", 0.9, false), force("fz", 2.9)]),
];

test("forces are listed by what more films buy, and those that none tells are named", () => {
  assert.deepEqual(
    knownForces(layouts).map(({ layout, force }) => [layout.film_count, force.axis]),
    [
      [12, "fz"],
      [24, "fz"],
      [48, "fz"],
    ],
  );
  assert.deepEqual(untoldAxes(layouts), ["fx"]);
});

test("the best layout has the least error on runs with other films", () => {
  assert.equal(bestKnown(knownForces(layouts), "fz")?.layout.rank, 1);
  assert.equal(bestKnown(knownForces(layouts), "fx"), undefined);
});

test("a drift's range holds the study's own", () => {
  const drift = [0.5, 3].map((rmse_n) => ({ drift: "none", error: trial(rmse_n), in_contact: trial(rmse_n) }));
  assert.deepEqual(rangeByDrift({ ...force("fz", 1), drift }), [0.5, 3]);
  assert.deepEqual(rangeByDrift({ ...force("fz", 4), drift }), [0.5, 4]);
  assert.equal(rangeByDrift(force("fz", 1)), null);
});

test("a study without a rig has no forces", () => {
  assert.deepEqual(knownForces([layout(1, 12)]), []);
  assert.deepEqual(untoldAxes([layout(1, 12)]), []);
});
