/** Recordings that were dropped, before they are sent. */

/** A file as it was read. */
export interface RecordingFile {
  file: string;
  text: string;
}

/** What a glance at a recording shows: its columns and how many rows it has. */
export function glance({ text }: RecordingFile): { columns: string[]; rows: number } {
  const head = text.slice(0, text.indexOf("\n") < 0 ? text.length : text.indexOf("\n"));
  const columns = head
    .replace(/^\uFEFF/, "")
    .trim()
    .split(",")
    .map((name) => name.trim().replace(/^"|"$/g, ""))
    .filter((name) => name !== "");
  let lines = 0;
  for (let at = text.indexOf("\n"); at >= 0; at = text.indexOf("\n", at + 1)) lines += 1;
  return { columns, rows: Math.max(0, text.endsWith("\n") || text === "" ? lines - 1 : lines) };
}

/** The columns in a few words: the first and the last of many. */
export function columnWords(columns: readonly string[]): string {
  if (columns.length <= MOST_COLUMNS) return columns.join(", ");
  return `${columns.slice(0, 3).join(", ")}, … ${columns.slice(-2).join(", ")}`;
}

const MOST_COLUMNS = 7;

/** The files with newer ones among them: one of the same name takes the place of the earlier. */
export function withFiles(files: readonly RecordingFile[], newer: readonly RecordingFile[]): RecordingFile[] {
  const names = new Set(newer.map(({ file }) => file));
  return [...files.filter(({ file }) => !names.has(file)), ...newer].sort((a, b) => a.file.localeCompare(b.file, "en", { numeric: true }));
}
