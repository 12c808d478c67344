import assert from "node:assert/strict";
import { test } from "node:test";
import type { LayoutScore, RankedLayout } from "../../wire.ts";
import { bestOfFew, countWords, isPapers, layoutWords, loadWords, placesWords, short, unitLines, withPlaces, worstLoad } from "./layout-words.ts";

function layout(change: Partial<RankedLayout>): RankedLayout {
  return { rank: 1, spacing_deg: 60, units: 6, position: "crown", films: ["x", "y"], film_count: 12, loads: [], score: { noise_strain: 1e-3 }, ...change };
}

const PLACES = [
  { theta_deg: 0, phi_deg: 0, angle_deg: 0 },
  { theta_deg: 22.5, phi_deg: 45, angle_deg: 90 },
  { theta_deg: 120, phi_deg: 0, angle_deg: 0 },
];

test("a layout is told in words", () => {
  assert.equal(layoutWords(layout({})), "12 films along x and y at the crown, a pair every 60°");
  const spread = layout({ units: 18, spacing_deg: 20, position: "30 deg", films: ["x", "45", "y"], film_count: 54, staggered: true });
  assert.equal(layoutWords(spread), "54 films along x, 45° and y in turn 30° from the crown, one every 6.67°");
  const free = layout({ name: "best 3 films, 1", spacing_deg: null, position: "mixed", places: PLACES });
  assert.deepEqual([countWords(spread), countWords({ ...free, film_count: 3 })], ["54 films along x, 45° and y in turn", "3 films"]);
  assert.equal(layoutWords(free), "best 3 films, 1: 0° x at 0, 120°; 45° y at 22.5°");
});

test("films are counted, and units where a unit has several", () => {
  assert.deepEqual(unitLines(layout({})), ["12 films", "in 6 units"]);
  assert.deepEqual(unitLines(layout({ units: 30, film_count: 30, films: ["x"] })), ["30 films"]);
  assert.deepEqual(unitLines(layout({ units: 1, film_count: 2 })), ["2 films", "in 1 unit"]);
  assert.deepEqual(unitLines(layout({ units: 1, film_count: 1, spacing_deg: null })), ["1 film"]);
});

test("a load is told by depth and force, as far as they are known", () => {
  assert.equal(loadWords({ depth_mm: 0.5000000000000071, load_n: 5.0456 }), "0.5 mm (5.05 N)");
  assert.equal(loadWords({ depth_mm: 2, load_n: null }), "2 mm");
  assert.equal(loadWords({ depth_mm: null, load_n: 20 }), "20 N");
});

test("the load of a layout's scores is found, and none where there are no scores", () => {
  const at = (p95: number): LayoutScore => ({ noise_strain: 1e-3, simulated_p95_angle_error_deg: p95 });
  const loads = [
    { depth_mm: 1, load_n: 13, score: at(3) },
    { depth_mm: 2, load_n: 32, score: at(5) },
  ];
  assert.equal(worstLoad(layout({ loads, score: at(5) }))?.depth_mm, 2);
  assert.equal(worstLoad(layout({})), null);
});

test("numbers are short, but keep what stands before the point", () => {
  assert.deepEqual(
    [null, NaN, 131.76, 0.8665, 1.9e-13, -2].map((value) => short(value, 2)),
    ["—", "—", "132", "0.87", "0", "-2"],
  );
});

test("the best of few films is the one with the least error", () => {
  const of = (film_count: number, p95: number | null) => layout({ film_count, score: { noise_strain: 1, simulated_p95_angle_error_deg: p95 } });
  const [many, few, fewer, unknown] = [of(48, 1), of(12, 11), of(10, 30), of(8, null)];
  assert.equal(bestOfFew([many, fewer, few, unknown], 12), few);
  assert.equal(bestOfFew([many, unknown], 12), null);
});

test("the paper's layout is known by its units and films", () => {
  assert.ok(isPapers(layout({ films: ["y", "x"] })));
  for (const other of [{ staggered: true }, { films: ["x"] }, { units: 12, spacing_deg: 30 }, { position: "shoulder" }]) assert.ok(!isPapers(layout(other)));
});

test("a search's layout is found among the ranked ones", () => {
  const free = layout({ spacing_deg: null, places: PLACES });
  assert.equal(withPlaces([layout({}), free], [...PLACES]), free);
  assert.equal(withPlaces([layout({}), free], PLACES.slice(1)), null);
  assert.equal(placesWords([]), "");
});
