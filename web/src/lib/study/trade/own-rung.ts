/** Where a study stands on the ladder that was measured for it, and what the next step costs. */

import type { Rung, Trade } from "../../../wire.ts";
import { duration, significant } from "../../format.ts";
import { front } from "./trade-marks.ts";

/** Mesh and method of a study. */
interface Fidelity {
  level: string;
  method: string;
  nodes: number;
}

/** Reads them from a study's canonical document and the level that it was solved on. */
export function fidelityOf(document: Record<string, unknown>, level: string): Fidelity | null {
  const { method } = document as { method?: { kind?: unknown; nodes?: unknown } | null };
  return typeof method?.kind === "string" && typeof method.nodes === "number" ? { level, method: method.kind, nodes: method.nodes } : null;
}

/** The study's own rung; null where none has its mesh and method. */
export function ownRung(trade: Trade, own: Fidelity | null): Rung | null {
  const isSame = ({ fidelity }: Rung): boolean => fidelity.level === own?.level && fidelity.method === own.method && fidelity.nodes === own.nodes;
  return trade.rungs.find(isSame) ?? null;
}

/** The fastest rung of the Pareto front that is nearer to the reference than this one; null at the front's end. */
export function nextRung(trade: Trade, own: Rung): Rung | null {
  const truth = own.error_true;
  if (truth == null) return null;
  return front(trade).find(({ rung, error }) => rung.wall_s > own.wall_s && error < truth)?.rung ?? null;
}

/** Where the study stands, and what the next step would bring and cost. */
export function stepWords(trade: Trade, own: Rung | null): string {
  if (own === null) return "No rung has the mesh and method of this study.";
  const here = `This study is ${own.label}: ${duration(own.wall_s)}, off by ${significant(own.error_true, 2)}.`;
  const next = nextRung(trade, own);
  if (next === null) return `${here} No measured rung that takes longer comes nearer to the reference.`;
  return `${here} The next step, ${next.label}, takes ${significant(next.wall_s / own.wall_s, 2)} times as long (${duration(next.wall_s)}) and is off by ${significant(next.error_true, 2)}.`;
}
