/** What a draft changes of the document that it began with, as an address says it: `/scene/geometry/wall_mm=4.5`. */

import { changes } from "./document-differences.ts";
import { isTable, withValue } from "./document-values.ts";

/** Values by JSON pointer: JSON, a text that isn't JSON as it stands, or nothing where the value is taken away. */
export type Edits = Readonly<Record<string, string>>;

/** The edits that make one document of another; null where no edits do. */
export function editsOf(before: unknown, after: unknown): Edits | null {
  if (!isTable(after)) return null;
  const edits = Object.fromEntries(changes(before, after).flatMap((change) => leavesOf(change.pointer, change)));
  return changes(edited(before, edits), after).length === 0 ? edits : null;
}

/** The document with these edits. */
export function edited(document: unknown, edits: Edits): unknown {
  return Object.entries(edits).reduce((made, [pointer, text]) => withValue(made, pointer, readValue(text)), document);
}

/** The fields in which two sets of edits differ. */
export function changedFields(before: Edits, after: Edits): string {
  const fields = new Set([...Object.keys(before), ...Object.keys(after)]);
  return [...fields].filter((field) => before[field] !== after[field]).join(" ");
}

/** A new table by its fields, anything else as a whole. */
function leavesOf(pointer: string, { before, after }: { before: unknown; after: unknown }): [string, string][] {
  const fields = before === undefined && isTable(after) ? changes({}, after) : [];
  return fields.length === 0 ? [[pointer, writtenValue(after)]] : fields.flatMap((field) => leavesOf(`${pointer}${field.pointer}`, field));
}

function writtenValue(value: unknown): string {
  if (value === undefined) return "";
  const isPlain = typeof value === "string" && !/[\ud800-\udfff]/.test(value) && value !== "" && readValue(value) === value;
  return isPlain ? value : JSON.stringify(value);
}

function readValue(text: string): unknown {
  if (text === "") return undefined;
  try {
    return JSON.parse(text) as unknown;
  } catch {
    return text;
  }
}
