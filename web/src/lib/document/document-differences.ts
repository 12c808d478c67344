/** What differs between two study documents, and the name that says so. */

import { isTable, resolved, valueAt, withValue, type SceneOfName } from "./document-values.ts";
import { pointerKeys } from "./json-pointer.ts";

export interface Difference {
  pointer: string;
  /** The field in short: wall_mm, depths_mm[2], P1 max. */
  label: string;
  before: unknown;
  after: unknown;
}

/** Fields whose values differ, in the order of the newer document; the name is no difference. */
export function differences(before: unknown, after: unknown): Difference[] {
  return changes(before, after)
    .filter(({ pointer }) => pointer !== "/name")
    .map((change) => ({ ...change, label: labelOf(change.pointer, after) }));
}

/** The same with the name, without labels. */
export function changes(before: unknown, after: unknown): Omit<Difference, "label">[] {
  const found: Omit<Difference, "label">[] = [];
  walk(before, after, "", (pointer, old, fresh) => found.push({ pointer, before: old, after: fresh }));
  return found;
}

type Visit = (pointer: string, before: unknown, after: unknown) => void;

function walk(before: unknown, after: unknown, pointer: string, visit: Visit): void {
  const alike = (Array.isArray(before) && Array.isArray(after) && before.length === after.length) || (isTable(before) && isTable(after));
  if (!alike) {
    if (JSON.stringify(before) !== JSON.stringify(after)) visit(pointer, before, after);
    return;
  }
  const [old, fresh] = [before as Record<string, unknown>, after as Record<string, unknown>];
  for (const key of new Set([...Object.keys(fresh), ...Object.keys(old)])) {
    walk(old[key], fresh[key], `${pointer}/${key.replaceAll("~", "~0").replaceAll("/", "~1")}`, visit);
  }
}

/** The last key with its index; of inputs their name and the last key, of the accuracy its own. */
function labelOf(pointer: string, document: unknown): string {
  const keys = pointerKeys(pointer);
  const last = keys.at(-1) ?? "document";
  if (keys[0] === "inputs" && keys.length > 2) {
    const name = valueAt(document, `/inputs/${keys[1]}/name`);
    return `${typeof name === "string" ? name : `input ${Number(keys[1]) + 1}`} ${last}`;
  }
  if (keys[0] === "accuracy") return "accuracy";
  return /^\d+$/.test(last) && keys.length > 1 ? `${keys.at(-2)}[${last}]` : last;
}

/** What a draft changes of the document that it began with, shipped scenes in full on both sides. */
export function changesSince(origin: { document: unknown } | null, document: unknown, scenes: readonly SceneOfName[]): Difference[] {
  return origin === null ? [] : differences(resolved(origin.document, scenes), resolved(document, scenes));
}

/** The document to submit: where its writer left the name of the first, the name says what differs. */
export function named(document: unknown, origin: { name: string; document: unknown } | null, scenes: readonly SceneOfName[]): unknown {
  if (origin === null || !isTable(document) || document.name !== origin.name) return document;
  return withValue(document, "/name", changedName(origin.name, changesSince(origin, document, scenes)));
}

/** Differences that are listed one by one; of more the number is told. */
const MOST_LISTED = 3;
const LONGEST_VALUE = 24;

/** "wall_mm 5 instead of 4"; null when nothing differs. */
export function differenceWords(found: readonly Difference[]): string | null {
  if (found.length === 0) return null;
  const words = found.slice(0, MOST_LISTED).map(({ label, before, after }) => `${label} ${shown(after)} instead of ${shown(before)}`);
  return `${words.join(", ")}${furtherWords(found.length)}`;
}

const MARK = " · ";
/** The longest that the service takes. */
const LONGEST_NAME = 200;

/** The name of a study that came from another: what its fields are now stands behind the name of the first. */
export function changedName(original: string, found: readonly Difference[]): string {
  if (found.length === 0) return original;
  const [base = original, ...tail] = original.split(MARK);
  const settings = new Map(
    tail
      .join(MARK)
      .split(", ")
      .flatMap((part) => {
        const [label, value] = part.split(" = ");
        return label === undefined || value === undefined ? [] : [[label, value] as const];
      }),
  );
  for (const { label, after } of found) settings.set(label, shown(after));
  const words = [...settings].slice(0, MOST_LISTED).map(([label, value]) => `${label} = ${value}`);
  const suffix = `${MARK}${words.join(", ")}${furtherWords(settings.size)}`;
  return `${base.slice(0, Math.max(0, LONGEST_NAME - suffix.length))}${suffix}`;
}

function furtherWords(count: number): string {
  return count > MOST_LISTED ? ` and ${count - MOST_LISTED} more` : "";
}

interface ComparedField {
  pointer: string;
  label: string;
  /** As words, one of each document. */
  values: string[];
}

/** The fields in which any of the documents differs from the first. */
export function comparedFields(documents: readonly unknown[]): ComparedField[] {
  const [first, ...others] = documents;
  const fields = new Map<string, string>();
  for (const other of others) for (const { pointer, label } of differences(first, other)) fields.set(pointer, label);
  // What lies within a field that another document has otherwise as a whole is told by that field.
  const outer = [...fields].filter(([pointer]) => ![...fields.keys()].some((other) => pointer.startsWith(`${other}/`)));
  return outer.map(([pointer, label]) => ({ pointer, label, values: documents.map((document) => shown(valueAt(document, pointer))) }));
}

function shown(value: unknown): string {
  if (value === undefined) return "none";
  if (isTable(value)) return "a table";
  const text = typeof value === "string" ? value : JSON.stringify(value).replaceAll(",", " ");
  return text.length > LONGEST_VALUE ? `${text.slice(0, LONGEST_VALUE - 1)}…` : text;
}
