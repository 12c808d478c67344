/** Files that the page makes of what it shows. */

import { csvCell } from "./csv-cells.ts";

/** Longest part of a name that comes from a study. */
const LONGEST = 48;

/** `foot-tire-five-contact-depths-indices-x.svg`: plain letters for any file system. */
export function fileName(study: string, figure: string, extension: string): string {
  return `${plain(study).slice(0, LONGEST).replace(/-+$/, "") || "study"}-${plain(figure)}.${extension}`;
}

function plain(text: string): string {
  return text
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-+|-+$/g, "");
}

/** Rows of texts as CSV (RFC 4180). */
export function csvOf(rows: readonly (readonly string[])[]): string {
  return `${rows.map((row) => row.map(cell).join(",")).join("\r\n")}\r\n`;
}

function cell(text: string): string {
  return csvCell(text.replace(/\s+/g, " ").trim().replaceAll("−", "-"));
}
