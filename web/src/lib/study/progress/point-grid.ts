/** The points of a study as a picture of its plan: a line for each input through the point at the means. */

import { valueAt } from "../../document/document-values.ts";
import { inputsOf } from "../../document/form/input-laws.ts";
import type { Estimate } from "../../../wire.ts";
import type { Progress } from "../point-progress.ts";

export type Dot = "open" | "solved" | "failed";

export interface DotRow {
  name: string;
  dots: Dot[];
  /** Where the point at the means stands between the dots; null where the row has none. */
  cut: number | null;
}

export interface DotBlock {
  title: string;
  /** Of the point at the means, which all lines share. */
  cut: Dot;
  rows: DotRow[];
}

/** Dots beyond this are told by the bar alone. */
const MOST_DOTS = 600;

/**
 * The picture of a study's plan; null where its method doesn't solve lines, or where they are too many. The service counts ordinals through: the point at
 * the means, the nodes of each input, the points off the lines, then the same on the coarser mesh.
 */
export function dotBlocks(document: unknown, estimate: Estimate | null | undefined, progress: Progress): DotBlock[] | null {
  if (estimate == null || valueAt(document, "/accuracy/preset") === undefined) return null;
  const { own, coarser } = estimate.solves;
  const lines = linesOf(document, own);
  if (lines === null || own + coarser > MOST_DOTS) return null;
  const level = String(valueAt(document, "/accuracy/preset"));
  const dotAt = dotsOf(progress);
  const blocks = [blockOf(`The ${level} mesh`, 0, own, lines, dotAt)];
  if (coarser === own) blocks.push(blockOf("A coarser mesh, for the mesh's error", own, own, lines, dotAt));
  return blocks;
}

interface Lines {
  names: string[];
  /** Nodes of each line beside the point at the means. */
  nodes: number;
}

/**
 * A line has as many nodes as asked for, or one fewer where the middle one is the point at the means. The lines are told apart by their number alone
 * when all have as many: with n inputs of which 0 < s < n lack a node the sum isn't divisible by n.
 */
function linesOf(document: unknown, own: number): Lines | null {
  const kind = valueAt(document, "/method/kind") ?? "mdrm";
  const names = inputsOf(document).map(({ name }) => name);
  const checks = valueAt(document, "/method/check_points") ?? 5;
  if (kind !== "mdrm" || names.length === 0 || typeof checks !== "number") return null;
  const nodes = (own - 1 - checks) / names.length;
  return Number.isInteger(nodes) && nodes > 0 ? { names, nodes } : null;
}

function dotsOf({ newton, failures, state }: Progress): (ordinal: number) => Dot {
  const failed = new Set(failures.map(({ ordinal }) => ordinal));
  return (ordinal) => (failed.has(ordinal) ? "failed" : newton.has(ordinal) || state === "done" ? "solved" : "open");
}

function blockOf(title: string, first: number, count: number, { names, nodes }: Lines, dotAt: (ordinal: number) => Dot): DotBlock {
  const dots = (from: number, to: number): Dot[] => Array.from({ length: to - from }, (_, index) => dotAt(first + from + index));
  const rows = names.map((name, line): DotRow => {
    const from = 1 + line * nodes;
    return { name, dots: dots(from, from + nodes), cut: Math.ceil(nodes / 2) };
  });
  const off = dots(1 + names.length * nodes, count);
  if (off.length > 0) rows.push({ name: "checks", dots: off, cut: null });
  return { title, cut: dotAt(first), rows };
}

/** How many dots are solved or failed. */
export function countDots(blocks: readonly DotBlock[], kind: Dot): number {
  return blocks.reduce(
    (sum, { cut, rows }) => sum + Number(cut === kind) + rows.reduce((all, { dots }) => all + dots.filter((dot) => dot === kind).length, 0),
    0,
  );
}
