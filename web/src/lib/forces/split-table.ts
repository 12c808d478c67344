/** Models side by side on every split. */

import { type ForceReport, type ModelReport, MODELS_COLUMNS, type SplitKind } from "../../wire.ts";
import { fixed } from "../format.ts";
import { type Column, view } from "../study/figures/columns.ts";
import { newtons } from "./force-words.ts";

/** Columns of each split's error, and of what the choosing split and the strictest one say. */
export const SPLITS = view(MODELS_COLUMNS, "splits");
export const JUDGED = view(MODELS_COLUMNS, "judged", "leak");

/** The split that a column is of: `run` of `/model/splits/run/rmse_n`. */
export const splitOf = ({ at }: Column): string | undefined => at.split("/").at(-2);

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
