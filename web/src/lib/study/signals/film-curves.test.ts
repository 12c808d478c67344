import assert from "node:assert/strict";
import { test } from "node:test";
import type { SignalRow } from "../../../wire.ts";
import { panels } from "./film-curves.ts";

function row(change: Partial<SignalRow>): SignalRow {
  return {
    tire: "own",
    film: "bare",
    position: "crown",
    direction: "x",
    over: "load",
    load_n: 1,
    pressure_mpa: 0.2,
    contact_deg: 0,
    depth_mm: 0.1,
    strain: 1e-3,
    tension_1_n_per_mm: 0.1,
    charge_nc: 1,
    open_circuit_v: 10,
    output_v: 10,
    output_std_v: 0.1,
    state: "ok",
    error: { strain: 1e-4, charge_nc: 0.1, open_circuit_v: 2, output_v: 2 },
    ...change,
  };
}

test("a panel has a curve for each position and model, in order", () => {
  const rows = [
    row({ load_n: 5, open_circuit_v: 50 }),
    row({}),
    row({ load_n: 9, open_circuit_v: null, error: null, reason: "it bursts" }),
    row({ film: "coupled", open_circuit_v: 1, error: null }),
    row({ film: "transfer" }),
    row({ direction: "y" }),
    row({ over: "pressure" }),
  ];
  const [load, pressure, other] = panels(rows, ["load", "pressure"]);
  assert.deepEqual([load?.direction, pressure?.over, other?.direction], ["x", "pressure", "y"]);
  assert.deepEqual(
    load?.curves.map((curve) => [curve.film, curve.points.map((point) => point.at)]),
    [
      ["coupled", [1]],
      ["bare", [1, 5]],
    ],
  );
  assert.deepEqual(
    load?.curves.map((curve) => curve.points[0]?.error),
    [null, 2],
  );
  // 0 and 52 V, and a twentieth of that on both sides.
  assert.deepEqual(
    load?.volts.bare.map((v) => Math.round(10 * v)),
    [-26, 546],
  );
  assert.deepEqual(
    load?.range.map((v) => Math.round(10 * v)),
    [6, 94],
  );
});
