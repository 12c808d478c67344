import assert from "node:assert/strict";
import { test } from "node:test";
import type { Rung, Trade } from "../../../wire.ts";
import { fidelityOf, nextRung, ownRung, stepWords } from "./own-rung.ts";
import { placeLabels } from "./trade-labels.ts";

function rung(label: string, wall_s: number, error_true: number, pareto = true): Rung {
  const [level = "", method = "", nodes] = label.split(" ");
  return { label, wall_s, error_true, pareto, fidelity: { level, method, nodes: Number(nodes), check_points: 5 } } as Rung;
}

const TRADE = { rungs: [rung("draft mdrm 5", 0.2, 0.02), rung("coarse mdrm 5", 2, 0.03, false), rung("standard mdrm 5", 10, 0.004)] } as unknown as Trade;

test("a study finds its rung by mesh, method and nodes", () => {
  const own = fidelityOf({ method: { kind: "mdrm", nodes: 5 } }, "coarse");
  assert.equal(ownRung(TRADE, own)?.label, "coarse mdrm 5");
  assert.equal(ownRung(TRADE, fidelityOf({ method: { kind: "pce", nodes: 5 } }, "coarse")), null);
  assert.equal(fidelityOf({}, "coarse"), null);
});

test("the next step is the fastest on the front that is nearer", () => {
  assert.equal(nextRung(TRADE, TRADE.rungs[0] as Rung)?.label, "standard mdrm 5");
  assert.equal(nextRung(TRADE, TRADE.rungs[2] as Rung), null);
  assert.equal(stepWords(TRADE, null), "No rung has the mesh and method of this study.");
  assert.match(
    stepWords(TRADE, TRADE.rungs[0] as Rung),
    /^This study is draft mdrm 5: 0.2 s, off by 0.020\. The next step, standard mdrm 5, takes 50 times as long \(10 s\)/,
  );
  assert.match(stepWords(TRADE, TRADE.rungs[2] as Rung), /No measured rung/);
});

test("names of near points don't cover each other", () => {
  const points = [0, 1, 2, 3].map((k) => ({ x: 100 + k, y: 100 + 2 * k, text: `rung ${k}` }));
  const placed = placeLabels(points, 400, 300);
  assert.equal(placed.length, 4);
  const boxes = placed.map(({ x, y, anchor }) => ({ left: anchor === "start" ? x : x - 37, y }));
  for (const [k, a] of boxes.entries()) {
    for (const b of boxes.slice(k + 1)) assert.ok(Math.abs(a.left - b.left) >= 37 || Math.abs(a.y - b.y) >= 13, JSON.stringify([a, b]));
  }
});

test("a name that fits nowhere is left out", () => {
  assert.deepEqual(placeLabels([{ x: 10, y: 10, text: "a very long name" }], 30, 20), []);
});
