import assert from "node:assert/strict";
import { test } from "node:test";
import type { Knee } from "../../wire.ts";
import { kneeRows } from "./knee-rows.ts";

const knee = (section_deg: number, films: string[], units: number | null): Knee => ({ section_deg, films, units, dense_deg: 1, of_60_deg: null });

test("a row for each section angle and set of films", () => {
  const loads = [
    { depth_mm: 1, load_n: 13, knees: [knee(0, ["x", "y"], 24), knee(45, ["x"], null)] },
    { depth_mm: 2, load_n: null, knees: [knee(45, ["x"], 30)] },
  ];
  const told = kneeRows(loads).map(({ place, knees }) => [place, knees.map((found) => found?.units)]);
  assert.deepEqual(told, [
    ["0°, x+y", [24, undefined]],
    ["45°, x", [null, 30]],
  ]);
  assert.deepEqual(kneeRows([]), []);
});
