/** Recordings that were dropped, before they are sent. */

/** A file as it was read. */
export interface RecordingFile {
  file: string;
  text: string;
}

/** The text of a recording as the command line reads it: UTF-16 with its mark, UTF-8, or else Latin-1, in which every byte is a letter. */
export function textOf(bytes: Uint8Array): string {
  const [first, second] = bytes;
  if (first === 0xff && second === 0xfe) return new TextDecoder("utf-16le").decode(bytes);
  if (first === 0xfe && second === 0xff) return new TextDecoder("utf-16be").decode(bytes);
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch {
    // What browsers call Latin-1 is Windows' page, which has other letters from 0x80 to 0x9f.
    let text = "";
    for (let at = 0; at < bytes.length; at += AT_ONCE) text += String.fromCharCode(...bytes.subarray(at, at + AT_ONCE));
    return text;
  }
}

/** Letters made at once: a call takes no more arguments than that everywhere. */
const AT_ONCE = 8192;

/** Reads a recording. */
export async function recordingOf(file: File): Promise<RecordingFile> {
  return { file: file.name, text: textOf(new Uint8Array(await file.arrayBuffer())) };
}

/** What a glance at a recording shows: its columns and how many rows it has. Comments above the header are passed over. */
export function glance({ text }: RecordingFile): { columns: string[]; rows: number } {
  let begin = 0;
  for (let end = text.indexOf("\n"); end >= 0 && /^[#%]/.test(text.slice(begin, begin + 1)); end = text.indexOf("\n", begin)) begin = end + 1;
  const end = text.indexOf("\n", begin);
  const head = text
    .slice(begin, end < 0 ? text.length : end)
    .replace(/^\uFEFF/, "")
    .trim();
  const separator = [";", "\t", ","].find((letter) => head.includes(letter)) ?? " ";
  const columns = head
    .split(separator)
    .map((name) => name.trim().replace(/^"|"$/g, ""))
    .filter((name) => name !== "");
  let lines = 0;
  for (let at = end; at >= 0; at = text.indexOf("\n", at + 1)) lines += 1;
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
