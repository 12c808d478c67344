import assert from "node:assert/strict";
import { test } from "node:test";
import type { RankedLayout, RankedLocation, StudyResult } from "../../../wire.ts";
import { earlierAnswer } from "./earlier-answer.ts";

function place(name: string, rank: number, change: Partial<RankedLocation> = {}): RankedLocation {
  return { name, input: name, rank, rank_certain: true, gsi_x_percent: 72.9, gsi_y_percent: 55, gsi_x_error_percent: 2.9, ...change } as RankedLocation;
}

function layout(p95: number | null, change: Partial<RankedLayout> = {}): RankedLayout {
  const score = { noise_strain: 1e-3, simulated_p95_angle_error_deg: p95, error: { simulated_p95_angle_error_deg: 1.46 } };
  return { rank: 1, rank_certain: false, spacing_deg: 30, units: 12, position: "crown", films: ["x", "y"], film_count: 24, score, ...change };
}

function result(locations: RankedLocation[], layouts: RankedLayout[], left_out: object[] = []): StudyResult {
  return { locations, layouts, model: { left_out } } as unknown as StudyResult;
}

test("the layout gives the sentence, and the weaker verdict is the answer's", () => {
  const answer = earlierAnswer(result([place("P2", 2), place("P3", 1)], [layout(9.23)]));
  assert.equal(answer?.sentence, "Glue 12 units of x and y at the crown, every 30°: they know the contact angle to 9.2 ± 1.5° at the worst load.");
  assert.deepEqual([answer?.verdict, answer?.place?.verdict, answer?.layout?.verdict], ["unknown", "certain", "unknown"]);
  assert.equal(answer?.reason, "The layout ranks first, but the errors leave doubt.");
  assert.deepEqual([answer?.place?.names, answer?.place?.direction, answer?.place?.error], [["P3"], "x", 0.028999999999999998]);
});

test("a layout that loses the contact is unknown, however certain its rank", () => {
  const answer = earlierAnswer(result([], [layout(150, { rank_certain: true })]));
  assert.equal(answer?.verdict, "unknown");
  assert.equal(answer?.reason, "No layout finds the contact to 20°.");
});

test("places alone, shared ranks named together", () => {
  const answer = earlierAnswer(result([place("P2", 1, { gsi_y_percent: 80 }), place("P4", 1)], []));
  assert.equal(answer?.layout, null);
  assert.equal(answer?.verdict, "certain");
  assert.equal(answer?.sentence, "Glue films of y at P2 or P4: 80 % of the variation at the centre is told there.");
  assert.match(answer?.reason ?? "", /^P2, P4 share the first rank/);
});

test("nothing where nothing is ranked", () => {
  assert.equal(earlierAnswer(result([], [])), null);
  assert.equal(earlierAnswer(result([place("P1", 1, { input: null })], [layout(null)])), null);
});

test("the largest effect that is left out is named", () => {
  const parts = [{ what: "friction", why: "", effect: 0.06 }, { what: "film stiffness", why: "", effect: 0.9966 }, { what: "heat", why: "" }];
  const answer = earlierAnswer(result([place("P3", 1)], [], parts));
  assert.equal(answer?.left_out?.sentence, "Film stiffness: it would change the strain by 100 %.");
});
