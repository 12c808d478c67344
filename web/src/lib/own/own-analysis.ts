/** Indices of a model of the reader's own, as they are drawn and saved. */

import type { ModelAnalysis, ModelOutput } from "../../wire.ts";
import { csvCell } from "../shell/csv-cells.ts";

/** Bars of one drawing: what matters is among the largest. */
export const MOST_BARS = 20;

/** An input's share of an output's variance, in percent. */
export interface IndexBar {
  name: string;
  percent: number;
  /** Null where none is claimed. */
  error: number | null;
  total: number | null;
}

/** The largest first-order indices, largest first; none where the output has none. */
export function indexBars(inputs: readonly string[], { first_order, total, error }: ModelOutput): IndexBar[] {
  const percent = (share: number | undefined): number | null => (share === undefined ? null : 100 * share);
  const bars = (first_order ?? []).map((share, k) => ({
    name: inputs[k] ?? `input ${k + 1}`,
    percent: 100 * share,
    error: percent(error.by_input?.[k]),
    total: percent(total?.[k]),
  }));
  return bars.sort((a, b) => b.percent - a.percent).slice(0, MOST_BARS);
}

/** The points that are still to be run, as `gsa plan` writes them: all digits of every number. */
export function pointsText({ inputs, points }: Pick<ModelAnalysis, "inputs" | "points">): string {
  const rows = points.rows.map((row, k) => [points.ids[k] ?? k, ...row].map(String));
  return [["id", ...inputs.map(csvCell)], ...rows].map((cells) => `${cells.join(",")}\n`).join("");
}

/** How far the analysis is, in a sentence. */
export function standing({ evaluations, wanted, outputs }: Pick<ModelAnalysis, "evaluations" | "wanted" | "outputs">): string {
  const more = `${wanted} ${wanted === 1 ? "point is" : "points are"}`;
  if (outputs.length === 0) return `${more} to be run first.`;
  return wanted === 0 ? `Of ${evaluations} runs; no more are asked for.` : `Of ${evaluations} runs; ${more} asked for to be surer.`;
}
