import assert from "node:assert/strict";
import { test } from "node:test";
import { forceAnswer, noteWords } from "./force-words.ts";
import type { Kind, ModelReport, SplitReport } from "../../wire.ts";

const error = (rmse_n: number): SplitReport => ({
  by: "run",
  rmse_n,
  rmse_interval_n: [rmse_n - 0.1, rmse_n + 0.2],
  nrmse_percent: 3.339,
  mean_nrmse_percent: 20.59,
  r2: 0.97,
  coverage: 0.9585,
  width_n: 5.203,
});
const model = (kind: Kind, rmse_n: number, better_than_mean: boolean): ModelReport => ({
  model: kind,
  features: "slopes",
  validation: error(rmse_n),
  splits: { run: error(rmse_n) },
  leak_factor: 2,
  better_than_mean,
});

test("a force that is known has its error with the bootstrap's interval, on what was left out", () => {
  const answer = forceAnswer({ force: "fz_n", chosen: "ridge", chosen_features: "slopes", models: [model("ridge", 1.224, true), model("mean", 7.549, false)] });
  assert.ok(answer.isUseful);
  assert.equal(answer.sentence, "off by 1.22 N (1.12 to 1.42) on runs that it didn't learn from");
  assert.deepEqual(answer.facts, [
    ["Model", "ridge regression of signals, slopes"],
    ["Share of the range", "3.3 %; the training mean 20.6 %"],
    ["95 % interval", "5.20 N wide, holds 96 % of the rows"],
  ]);
});

test("a force that no model knows is called useless, with the best of the models", () => {
  const models = [model("mean", 1.807, false), model("gpr", 1.931, false), model("ridge", 1.766, false)];
  const answer = forceAnswer({ force: "fx_n", chosen: "mean", chosen_features: "raw", models });
  assert.ok(!answer.isUseful);
  assert.match(answer.sentence, /^useless: no model knows it 5 % better than the training mean, which is off by 1\.81 N on runs/);
  assert.deepEqual(answer.facts, [["Best model", "ridge regression of signals, slopes, off by 1.77 N"]]);
});

test("a blend is said by its members", () => {
  const blend: ModelReport = {
    ...model("blend", 1, true),
    members: [
      { model: "gpr", features: "slopes" },
      { model: "ann", features: "raw" },
    ],
  };
  const answer = forceAnswer({ force: "f", chosen: "blend", chosen_features: "slopes", models: [blend] });
  assert.deepEqual(answer.facts[0], ["Model", "median of 2 models: Gaussian process (slopes), neural network (raw)"]);
});

test("intervals that hold too few rows are said to", () => {
  const few = { ...model("gpr", 1, true), validation: { ...error(1), coverage: 0.88 } };
  assert.match(forceAnswer({ force: "f", chosen: "gpr", chosen_features: "raw", models: [few] }).facts[2]?.[1] ?? "", /holds only 88 %/);
});

test("notes are sentences, and names of forces stay as they are", () => {
  assert.equal(noteWords("the first reading is kept", ["fz_n"]), "The first reading is kept.");
  assert.equal(noteWords("fz_n: no split by frequency", ["fx_n", "fz_n"]), "fz_n: no split by frequency.");
});

test("an error without its interval, and a force without a model, are said plainly", () => {
  const bare = { ...model("gpr", 0.5, true), validation: { by: "random" as const, rmse_n: 0.5 } };
  assert.equal(
    forceAnswer({ force: "f", chosen: "gpr", chosen_features: "raw", models: [bare] }).sentence,
    "off by 0.500 N on rows drawn at random among those that it learnt from",
  );
  assert.equal(forceAnswer({ force: "f", chosen: "mean", chosen_features: "raw", models: [] }).sentence, "no model was judged");
});
