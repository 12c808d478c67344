/** Models side by side on every split. */

import { fixed } from "../format.ts";
import type { ForceReport, ModelReport, SplitKind } from "../../wire.ts";
import { MODELS, newtons, share } from "./force-words.ts";

export const SPLITS: readonly { split: SplitKind; title: string }[] = [
  { split: "random", title: "Random rows" },
  { split: "cycle", title: "Cycles" },
  { split: "run", title: "Runs" },
  { split: "time", title: "Later rows" },
  { split: "frequency", title: "Frequencies" },
];

export interface SplitRow {
  key: string;
  model: string;
  features: string;
  isChosen: boolean;
  /** RMSE of each split, in their order, N. */
  errors: string[];
  /** RMSE of the training mean isn't among the splits: this is its NRMSE, and the model's own, on the split that chooses. */
  nrmse: string;
  mean_nrmse: string;
  leak: string;
  coverage: string;
  width: string;
}

/** The chosen model first, then by error, as the service sends them. */
export function splitRows({ models }: ForceReport): SplitRow[] {
  return models.map((model, place) => ({
    key: `${model.model} ${model.features}`,
    model: MODELS[model.model],
    features: model.model === "mean" ? "" : model.features,
    isChosen: place === 0,
    errors: SPLITS.map(({ split }) => newtons(model.splits[split]?.rmse_n)),
    nrmse: fixed(model.validation.nrmse_percent, 1),
    mean_nrmse: fixed(model.validation.mean_nrmse_percent, 1),
    leak: fixed(model.leak_factor, 2),
    coverage: share(model.validation.coverage),
    width: newtons(model.validation.width_n),
  }));
}

/** The split that chose; null without a model. */
export function chosenBy({ models }: ForceReport): SplitKind | null {
  return models[0]?.validation.by ?? null;
}

/** How far a random split would have misled, of the chosen model; null where there are not both. */
export function leakWords({ models }: ForceReport): string | null {
  const [chosen] = models;
  const random = chosen?.splits.random;
  const strict = chosen?.splits.run ?? chosen?.splits.cycle;
  if (chosen === undefined || chosen.leak_factor == null || random == null || strict == null) return null;
  return `A random split would say ${newtons(random.rmse_n)} N where ${strictOf(chosen)} left out say ${newtons(strict.rmse_n)} N: ${fixed(chosen.leak_factor, 2)} times as much.`;
}

const strictOf = ({ splits }: ModelReport): string => (splits.run == null ? "cycles" : "runs");
