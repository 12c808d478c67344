/** Columns of figures as the service describes them: titles, units, decimals. */

import { fixed, integer, MISSING, percent } from "../../format.ts";

/** One figure of a table's rows. */
export interface Column {
  /** Pointer of its value in a row, as in `/layout/score/lost_share`. */
  readonly at: string;
  readonly kind: "float" | "share" | "integer" | "bool" | "text";
  readonly unit?: string;
  readonly title: string;
  readonly digits: number;
  /** Pointer of the claimed error. */
  readonly error_at?: string;
  readonly description?: string;
  /** Columns of the same view are shown together. */
  readonly view?: string;
}

/** Columns of a table's views, in their order. */
export function view(table: Readonly<Record<string, Column>>, ...names: string[]): Column[] {
  return names.flatMap((name) => Object.values(table).filter((column) => column.view === name));
}

const SIGNS: Record<string, string> = { deg: "°", 1: "" };

/** What stands above a column: its title with the unit; what it is on asking. */
export function heading({ title, kind, unit = "", description }: Column): { text: string; title?: string } {
  const sign = kind === "share" ? "%" : (SIGNS[unit] ?? unit);
  const text = `${title.charAt(0).toUpperCase()}${title.slice(1)} ${sign}`.trim();
  return description === undefined ? { text } : { text, title: description };
}

/** A column's value in a row, as people read it. */
export function shown(column: Column, row: unknown): string {
  return words(column, valueAt(row, column.at), column.digits);
}

/** The claimed error of a column's value in a row; undefined where there is none. */
export function shownError(column: Column, row: unknown): string | undefined {
  const error = column.error_at === undefined ? undefined : valueAt(row, column.error_at);
  return error == null ? undefined : words(column, error, column.digits);
}

function words({ kind }: Column, value: unknown, digits: number): string {
  if (kind === "bool") return value == null ? MISSING : value ? "yes" : "no";
  if (typeof value !== "number") return value == null ? MISSING : String(value);
  if (kind === "share") return percent(value, digits);
  return kind === "integer" ? integer(value) : fixed(value, digits);
}

function valueAt(row: unknown, pointer: string): unknown {
  let value = row;
  for (const step of pointer.split("/").slice(1)) {
    if (typeof value !== "object" || value === null) return undefined;
    value = (value as Record<string, unknown>)[step];
  }
  return value;
}
