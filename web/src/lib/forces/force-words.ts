/** What was found of a force, in words. */

import { fixed, significant } from "../format.ts";
import type { FeatureSet, ForceReport, Kind, ModelReport, SplitKind, SplitReport } from "../../wire.ts";

export const MODELS: Record<Kind, string> = {
  mean: "training mean",
  ridge: "ridge regression",
  gpr: "Gaussian process",
  ann: "neural network",
  blend: "blend",
};

const FEATURES: Record<FeatureSet, string> = {
  raw: "signals",
  baseline: "signals over their baselines",
  slopes: "signals, slopes",
  rolling: "signals, rolling means and variances",
  all: "signals, slopes, rolling means and variances",
  whole: "signals, signals over their baselines, slopes, rolling means and variances",
};

/** What a split left out, as a sentence ends. */
const LEFT_OUT: Record<SplitKind, string> = {
  random: "on rows drawn at random among those that it learnt from",
  cycle: "on cycles that it didn't learn from",
  run: "on runs that it didn't learn from",
  time: "on later rows than those that it learnt from",
  frequency: "on cycles of a frequency that it didn't learn from",
};

/** Intervals that hold fewer rows than this share don't keep what 95 % promises. */
const FEW = 0.9;

/** The answer of one force. */
interface ForceAnswer {
  force: string;
  isUseful: boolean;
  /** The error, or that there is no use in it. */
  sentence: string;
  /** Which model, and what the figures beside it are. */
  facts: [string, string][];
}

export function forceAnswer(report: ForceReport): ForceAnswer {
  const { force } = report;
  const [first] = report.models;
  if (first === undefined) return { force, isUseful: false, sentence: "no model was judged", facts: [] };
  const error = first.validation;
  if (!first.better_than_mean) {
    return {
      force,
      isUseful: false,
      sentence: `useless: no model knows it 5 % better than the training mean, which is off by ${newtons(error.rmse_n)} N ${LEFT_OUT[error.by]}`,
      facts: bestOf(report),
    };
  }
  return {
    force,
    isUseful: true,
    sentence: `off by ${newtons(error.rmse_n)} N${between(error)} ${LEFT_OUT[error.by]}`,
    facts: [
      ["Model", modelWords(first)],
      ["Share of the range", `${fixed(error.nrmse_percent, 1)} %; the training mean ${fixed(error.mean_nrmse_percent, 1)} %`],
      ["95 % interval", `${newtons(error.width_n)} N wide, holds ${(error.coverage ?? 1) < FEW ? "only " : ""}${share(error.coverage)} % of the rows`],
    ],
  };
}

/** A model with what it reads; a blend by its members. */
export function modelWords({ model, features, members }: ModelReport): string {
  if (members === undefined) return `${MODELS[model]} of ${FEATURES[features]}`;
  return `median of ${members.length} models: ${members.map((member) => `${MODELS[member.model]} (${member.features})`).join(", ")}`;
}

/** The best of the models that are none the better for it. */
function bestOf({ models }: ForceReport): [string, string][] {
  const others = models.filter(({ model }) => model !== "mean");
  const [best] = [...others].sort((a, b) => a.validation.rmse_n - b.validation.rmse_n);
  if (best === undefined) return [];
  return [["Best model", `${modelWords(best)}, off by ${newtons(best.validation.rmse_n)} N`]];
}

/** A note as a sentence; the name of a force stays as it is written. */
export function noteWords(note: string, forces: readonly string[]): string {
  const isNamed = forces.some((force) => note.startsWith(`${force}:`));
  return `${isNamed ? note : note.charAt(0).toUpperCase() + note.slice(1)}.`;
}

/** The bootstrap's interval in brackets. */
export function between({ rmse_interval_n }: SplitReport): string {
  return rmse_interval_n == null ? "" : ` (${newtons(rmse_interval_n[0])} to ${newtons(rmse_interval_n[1])})`;
}

export const newtons = (value: number | null | undefined): string => significant(value, 3);

export const share = (value: number | null | undefined): string => fixed(value == null ? null : 100 * value, 0);
