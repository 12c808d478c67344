/** Estimates as CSV: what the service answers, and what the page writes. */

import type { BandRow } from "./band-drawing.ts";
import type { LeftOutRows } from "../../wire.ts";
import { csvCell, csvText } from "../shell/csv-cells.ts";

/** The estimates of a recording, as the service sends them. */
export interface Estimates {
  forces: { force: string; rows: BandRow[] }[];
  rows: number;
  /** Rows with a signal beyond those that were learnt from. */
  outside: number;
}

/** Reads `time_s,<force>,<force>_low,<force>_high,...,outside`; null where it is something else. */
export function readEstimates(text: string): Estimates | null {
  const lines = text.split(/\r?\n/).filter((line) => line !== "");
  const names = cells(lines[0] ?? "");
  const forces = names.filter((_, column) => column % 3 === 1 && column < names.length - 1);
  if (names[0] !== "time_s" || names.at(-1) !== "outside" || names.length !== 3 * forces.length + 2) return null;
  const rows = lines.slice(1).map((line) => cells(line).map(Number));
  if (rows.some((row) => row.length !== names.length || row.some((value) => !Number.isFinite(value)))) return null;
  const of = (at: number): BandRow[] =>
    rows.map((row) => ({ time_s: row[0] ?? 0, truth_n: null, estimate_n: row[at] ?? 0, low_n: row[at + 1] ?? 0, high_n: row[at + 2] ?? 0 }));
  return {
    forces: forces.map((force, k) => ({ force, rows: of(1 + 3 * k) })),
    rows: rows.length,
    outside: rows.filter((row) => row.at(-1) !== 0).length,
  };
}

/** The cells of a line; names may be quoted. */
function cells(line: string): string[] {
  const found = [...line.matchAll(/(?:^|,)("(?:[^"]|"")*"|[^,]*)/g)].map(([, cell = ""]) => cell);
  return found.map((cell) => csvText(cell.startsWith('"') ? cell.slice(1, -1).replaceAll('""', '"') : cell));
}

/** Rows that were left out, with all digits: a row for each row and force. */
export function leftOutText(all: readonly LeftOutRows[], files: readonly string[]): string {
  const lines = all.flatMap((left) =>
    left.time_s.map((time_s, k) =>
      [csvCell(left.force), csvCell(files[left.run[k] ?? -1] ?? ""), time_s, left.truth_n[k], left.estimate_n[k], left.low_n[k], left.high_n[k]].join(","),
    ),
  );
  return `${["force,recording,time_s,truth_n,estimate_n,low_n,high_n", ...lines].join("\r\n")}\r\n`;
}
