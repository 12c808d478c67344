import assert from "node:assert/strict";
import { test } from "node:test";
import type { InputReport, Knee, LayoutFindings, RankedLayout } from "../../wire.ts";
import { asksForLayouts, kneeRows, tauMatrix } from "./film-criteria.ts";

const knee = (section_deg: number, films: string[], units: number | null): Knee => ({ section_deg, films, units, dense_deg: 1, of_60_deg: null });

test("a row for each section angle and set of films", () => {
  const loads = [
    { depth_mm: 1, load_n: 13, knees: [knee(0, ["x", "y"], 24), knee(45, ["x"], null)] },
    { depth_mm: 2, load_n: null, knees: [knee(45, ["x"], 30)] },
  ];
  const told = kneeRows(loads).map(({ place, knees }) => [place, knees.map((found) => found?.units)]);
  assert.deepEqual(told, [["0°, x+y", [24, undefined]], ["45°, x", [null, 30]]]);
  assert.deepEqual(kneeRows([]), []);
});

test("tau stands on both sides of the diagonal", () => {
  const { criteria, tau } = tauMatrix([{ first: "a", second: "b", tau: 0.5 }, { first: "a", second: "c", tau: null }]);
  assert.deepEqual(criteria, ["a", "b", "c"]);
  assert.deepEqual(tau, [[null, 0.5, null], [0.5, null, null], [null, null, null]]);
});

test("a study of layouts is known by its search or its single input", () => {
  const layouts: RankedLayout[] = [{ rank: 1, spacing_deg: 60, units: 6, position: "crown", films: ["x"], score: { noise_strain: 1 } }];
  const input: InputReport = { name: "P1", vary: "ground.depths_mm[0]", distribution: {} };
  const one = { depth_mm: 1, load_n: 13, knees: [] };
  const found: LayoutFindings = { level: "draft", loads: [one], front: [], tau_of_bound: null, candidates: [], agreement: [], rings: [] };
  const inputs = [input, input];
  assert.ok(!asksForLayouts({ inputs, layouts, layout_findings: found }));
  assert.ok(asksForLayouts({ inputs: [input], layouts, layout_findings: found }));
  const search = { films: 3, places: 24, method: "exhaustive", looked_at: 2024, bayes_angle_error_deg: 35, best: [] };
  assert.ok(asksForLayouts({ inputs, layouts, layout_findings: { ...found, searches: [search] } }));
  assert.ok(!asksForLayouts({ inputs: [input], layouts, layout_findings: null }), "an earlier result");
  assert.ok(!asksForLayouts({ inputs: [input], layouts: [], layout_findings: found }));
});
