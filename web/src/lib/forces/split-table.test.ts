import assert from "node:assert/strict";
import { test } from "node:test";
import type { ForceReport, SplitKind } from "../../wire.ts";
import { shown } from "../study/figures/columns.ts";
import { chosenBy, JUDGED, leakWords, SPLITS, splitOf } from "./split-table.ts";

const error = (by: SplitKind, rmse_n: number) => ({ by, rmse_n, nrmse_percent: 3.34, mean_nrmse_percent: 20.59, coverage: 0.958, width_n: 5.2 });
const FORCE: ForceReport = {
  force: "fz_n",
  chosen: "ridge",
  chosen_features: "raw",
  models: [
    {
      model: "ridge",
      features: "raw",
      validation: error("run", 1.334),
      splits: { random: error("random", 0.854), cycle: error("cycle", 1.087), run: error("run", 1.334), time: null },
      leak_factor: 1.563,
      better_than_mean: true,
    },
    { model: "mean", features: "raw", validation: error("run", 7.549), splits: { run: error("run", 7.549) }, better_than_mean: false },
  ],
};

test("columns of splits stand beside those of the split that chooses", () => {
  assert.deepEqual(SPLITS.map(splitOf), ["random", "cycle", "run", "time", "frequency"]);
  const row = { model: FORCE.models[0] };
  assert.deepEqual(
    SPLITS.map((column) => shown(column, row)),
    ["0.854", "1.087", "1.334", "—", "—"],
  );
  assert.deepEqual(
    JUDGED.map((column) => shown(column, row)),
    ["1.334", "3.34", "20.59", "—", "0.96", "5.200", "1.56"],
  );
});

test("the leak is told of the strictest split, and not where there isn't one", () => {
  assert.equal(chosenBy(FORCE), "run");
  assert.equal(leakWords(FORCE), "A random split would say 0.854 N where runs left out say 1.33 N: 1.56 times as much.");
  assert.equal(leakWords({ ...FORCE, models: FORCE.models.slice(1) }), null);
  assert.equal(chosenBy({ ...FORCE, models: [] }), null);
});
