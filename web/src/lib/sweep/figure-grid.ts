/** A sweep over two fields as a grid: the first field's values down, the second's across, a figure of each design in its cell. */

import type { ComparedIndex, Comparison, DesignView, LayoutAnswer } from "../../wire.ts";
import type { Direction } from "../direction.ts";
import { fixed, MISSING } from "../format.ts";
import type { CellFigure } from "../route.ts";
import { valueText, variedPaths, type Varied } from "./design-progress.ts";

export interface DesignGrid {
  rows: Varied;
  columns: Varied;
  /** Rows by columns; null where no design has both values. */
  designs: (DesignView | null)[][];
}

/** The grid of the designs; null unless exactly two fields vary. */
export function designGrid(designs: readonly DesignView[]): DesignGrid | null {
  const [rows, columns, ...others] = variedPaths(designs).filter(({ values }) => values.length > 1);
  if (rows === undefined || columns === undefined || others.length > 0) return null;
  const has = ({ set }: DesignView, { path }: Varied, value: string): boolean => path in set && valueText(set[path]) === value;
  const at = (row: string, column: string): DesignView | null => designs.find((design) => has(design, rows, row) && has(design, columns, column)) ?? null;
  return { rows, columns, designs: rows.values.map((row) => columns.values.map((column) => at(row, column))) };
}

/** What stands in a cell. */
export interface GridCell {
  words: string;
  /** The error of the value, or what is to be known of the words; null where there is nothing to say. */
  sure: string | null;
  /** What its colour goes by; null where it has none. */
  value: number | null;
}

/** A design's figure; of one without a result how far it is. */
export function cellOf(design: DesignView, figure: CellFigure, comparison: Comparison | null, layouts: ReadonlyMap<string, LayoutAnswer | null>): GridCell {
  const { study } = design;
  if (study.state !== "done") return standing(design);
  switch (figure) {
    case "answer":
      return answerOf(study.id, comparison);
    case "index-x":
      return indexOf(study.id, "x", comparison);
    case "index-y":
      return indexOf(study.id, "y", comparison);
    case "angle-error":
      return angleOf(study.id, layouts);
  }
}

function standing({ study }: DesignView): GridCell {
  const of = study.state === "running" && study.points_total != null ? `${study.points_done} of ${study.points_total} points` : null;
  return { words: study.state, sure: study.error?.toString() ?? of, value: null };
}

const COMING: GridCell = { words: "…", sure: null, value: null };

function answerOf(id: string, comparison: Comparison | null): GridCell {
  const study = comparison?.studies.find((each) => each.id === id);
  if (study === undefined) return COMING;
  if (study.best == null) return { words: "no best place", sure: study.reason ?? null, value: null };
  return { words: study.best, sure: study.best_certain === true ? "certain" : "uncertain", value: null };
}

/** The index of the best place's own depth. */
function indexOf(id: string, direction: Direction, comparison: Comparison | null): GridCell {
  const best = comparison?.studies.find((each) => each.id === id)?.best;
  const index: ComparedIndex | undefined = comparison?.rows.find((row) => row.study === id && row.location === best)?.[direction];
  if (comparison === null || index === undefined) return comparison === null ? COMING : { words: MISSING, sure: "no ranked place", value: null };
  return withError(index.gsi_percent ?? null, index.error_percent ?? null, 1);
}

function angleOf(id: string, layouts: ReadonlyMap<string, LayoutAnswer | null>): GridCell {
  const layout = layouts.get(id);
  if (layout === undefined) return COMING;
  if (layout === null) return { words: MISSING, sure: "no layout", value: null };
  return withError(layout.angle_error_deg, layout.error_deg ?? null, 1);
}

function withError(value: number | null, error: number | null, decimals: number): GridCell {
  return { words: fixed(value, decimals), sure: error === null ? "± ?" : `± ${fixed(error, decimals)}`, value };
}

/** Ends of the values that have a colour; null without any. */
export function valueRange(cells: readonly GridCell[]): [low: number, high: number] | null {
  const values = cells.flatMap(({ value }) => (value === null ? [] : [value]));
  return values.length === 0 ? null : [Math.min(...values), Math.max(...values)];
}
