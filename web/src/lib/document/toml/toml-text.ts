/** The document being written as TOML, both ways. Loaded with its reader by those who write TOML alone. */

import { parse, stringify, TomlError } from "smol-toml";
import { parseDraft, textOf, type SyntaxFault } from "../draft-text.ts";

/** What was typed, and the draft's text that it stands for. */
export interface TypedToml {
  typed: string;
  of: string;
  fault: SyntaxFault | null;
}

/** What is typed, as JSON for the draft. What is no TOML is kept as it is, so that the draft is no document either; JSON that is pasted is taken for what it is. */
export function readToml(typed: string): TypedToml {
  try {
    const document = parse(typed);
    const fault = unwritable(document, "");
    return fault === null ? { typed, of: textOf(document), fault } : { typed, of: typed, fault };
  } catch (error) {
    const isJson = !("fault" in parseDraft(typed));
    return { typed, of: typed, fault: isJson ? null : { detail: detailOf(error) } };
  }
}

/** A draft as TOML: as it was typed while it is that draft. One that can't be written so is shown as it is. */
export function tomlOf(text: string, typed: TypedToml | null): string {
  if (typed !== null && typed.of === text) return typed.typed;
  const parsed = parseDraft(text);
  if ("fault" in parsed || typeof parsed.document !== "object" || parsed.document === null) return text;
  try {
    return stringify(parsed.document);
  } catch {
    // An empty entry of a list, which TOML doesn't have.
    return text;
  }
}

function detailOf(error: unknown): string {
  if (!(error instanceof TomlError)) return `This is not TOML yet: ${error instanceof Error ? error.message : String(error)}`;
  const what = error.message.split("\n")[0]?.replace("Invalid TOML document: ", "") ?? "";
  return `This is not TOML yet. Line ${error.line}, column ${error.column}: ${what}.`;
}

/** What TOML has and JSON hasn't: dates, and numbers that aren't finite. Null where there is nothing of it. */
function unwritable(value: unknown, path: string): SyntaxFault | null {
  if (value instanceof Date) return { detail: `${path} is a date, which no field takes.` };
  if (typeof value === "number" && !Number.isFinite(value)) return { detail: `${path} is ${value}: a number of a document is finite.` };
  if (typeof value !== "object" || value === null) return null;
  for (const [key, entry] of Object.entries(value)) {
    const fault = unwritable(entry, `${path}${Array.isArray(value) ? `[${key}]` : `${path === "" ? "" : "."}${key}`}`);
    if (fault !== null) return fault;
  }
  return null;
}
