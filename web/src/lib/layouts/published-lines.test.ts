import assert from "node:assert/strict";
import { test } from "node:test";
import type { PublishedRow } from "../../wire.ts";
import { publishedLines } from "./published-lines.ts";

const row = (part: Partial<PublishedRow>): PublishedRow => ({
  table: 4,
  gait: "randomised",
  model: "gpr",
  features: "raw",
  axis: "fx",
  by: "random",
  printed: { nrmse_percent: 10, rmse_n: null, r2: null, mean_nrmse_percent: null },
  rig: null,
  fresh: null,
  ...part,
});

test("forces of one line stand beside each other, in their order", () => {
  const lines = publishedLines([row({ axis: "fz" }), row({}), row({ features: "all" })]);
  assert.deepEqual(
    lines.map((line) => [line.model, line.forces.map((force) => force?.axis)]),
    [
      ["Gaussian process, raw", ["fx", undefined, "fz"]],
      ["Gaussian process, all", ["fx", undefined, undefined]],
    ],
  );
});

test("what comes before and after cross-validation are two lines", () => {
  const rows = [row({ table: 9, model: "ann", by: "random" }), row({ table: 9, model: "ann", by: "time" }), row({ table: 6, by: "run", gait: "1 Hz" })];
  const models = publishedLines(rows).map((line) => line.model);
  assert.deepEqual(models, ["neural network, before cross-validation", "neural network, after cross-validation", "Gaussian process"]);
});
