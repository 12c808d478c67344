import type { PublishedRow } from "../../wire.ts";

/** The forces of one printed line, in the order along, across, vertical. */
export interface PublishedLine {
  key: string;
  table: number;
  gait: string;
  model: string;
  forces: (PublishedRow | undefined)[];
}

const AXES = ["fx", "fy", "fz"];

/** Rows of one table, gait and model as one line. */
export function publishedLines(rows: PublishedRow[]): PublishedLine[] {
  const keyOf = (row: PublishedRow): string => [row.table, row.gait, row.model, row.features, row.by].join(" ");
  return [...new Set(rows.map(keyOf))].flatMap((key) => {
    const own = rows.filter((row) => keyOf(row) === key);
    const [first] = own;
    if (first === undefined) return [];
    return [{ key, table: first.table, gait: first.gait, model: modelWords(first), forces: AXES.map((axis) => own.find((row) => row.axis === axis)) }];
  });
}

/** The model, with what tells its lines apart. */
function modelWords(row: PublishedRow): string {
  const model = row.model === "gpr" ? "Gaussian process" : "neural network";
  if (row.table <= 5) return `${model}, ${row.features}`;
  if (row.table >= 8) return `${model}, ${row.by === "time" ? "after" : "before"} cross-validation`;
  return model;
}
