/** The document being written: its text, and what the form's own controls change in it. */

import { isTable, valueAt } from "./document-values.ts";

export const ACCURACIES = ["draft", "coarse", "standard", "reference"] as const;
export type Accuracy = (typeof ACCURACIES)[number];

/** Where the text stops being JSON. */
export interface SyntaxFault {
  detail: string;
}

export function textOf(document: unknown): string {
  return JSON.stringify(document, null, 2);
}

/** The document, or why the text is none. */
export function parseDraft(text: string): { document: unknown } | { fault: SyntaxFault } {
  try {
    return { document: JSON.parse(text) as unknown };
  } catch (error) {
    return { fault: { detail: `This is not JSON yet: ${error instanceof Error ? error.message : String(error)}` } };
  }
}

/** The preset of the draft's accuracy; null when it has a tolerance or a budget instead, or isn't JSON. */
export function accuracyOf(text: string): Accuracy | null {
  const parsed = parseDraft(text);
  const preset = "fault" in parsed ? undefined : valueAt(parsed.document, "/accuracy/preset");
  return ACCURACIES.find((name) => name === preset) ?? null;
}

/** The draft with another accuracy preset; unchanged while it isn't JSON. */
export function withAccuracy(text: string, preset: Accuracy): string {
  const parsed = parseDraft(text);
  if ("fault" in parsed || !isTable(parsed.document)) return text;
  return textOf({ ...parsed.document, accuracy: { preset } });
}
