import assert from "node:assert/strict";
import { test } from "node:test";
import type { Rung, Trade } from "../../../wire.ts";
import { cheapest, front, LEAST_ERROR, trueMarks } from "./trade-marks.ts";

function rung(label: string, wall_s: number, change: Partial<Rung> = {}): Rung {
  return {
    label,
    fidelity: { level: "coarse", method: "mdrm", nodes: 5, check_points: 0 },
    indices: [],
    wall_s,
    cpu_s: wall_s,
    solves: 1,
    error_true: 0.1,
    error_claimed: 0.2,
    covered: 1,
    ranking_agrees: true,
    pareto: false,
    ...change,
  };
}

function trade(rungs: Rung[]): Trade {
  return { study: "a", spec_sha256: "b", reference: rung("best", 100), rungs };
}

test("a rung without an error has no mark, and an error of zero has the least", () => {
  const found = trueMarks(trade([rung("a", 1, { error_true: null }), rung("b", 2, { error_true: 0 })]));
  assert.deepEqual(
    found.map((mark) => [mark.rung.label, mark.error]),
    [["b", LEAST_ERROR]],
  );
});

test("the front goes from fast to slow", () => {
  const rungs = [rung("slow", 9, { pareto: true }), rung("beaten", 5), rung("fast", 1, { pareto: true })];
  assert.deepEqual(
    front(trade(rungs)).map((mark) => mark.rung.label),
    ["fast", "slow"],
  );
});

test("the cheapest is the fastest that ranks as the reference", () => {
  const rungs = [rung("wrong", 1, { ranking_agrees: false }), rung("right", 3), rung("slower", 5)];
  assert.equal(cheapest(trade(rungs))?.label, "right");
  assert.equal(cheapest(trade([rung("wrong", 1, { ranking_agrees: false })])), null);
});
