/** Entries of the lists that can't be told apart by their names. */

import { differences, differenceWords } from "../../document/document-differences.ts";

/** The entries that share their name with another, newest first as they come. */
export function namesakes<T extends { name: string }>(entries: readonly T[]): T[][] {
  const groups = new Map<string, T[]>();
  for (const entry of entries) groups.set(entry.name, [...(groups.get(entry.name) ?? []), entry]);
  return [...groups.values()].filter((group) => group.length > 1);
}

/** By entry what differs from the oldest of its name, as far as the documents are known. */
export function differenceNotes(entries: readonly { id: string; name: string }[], documents: ReadonlyMap<string, unknown>): Map<string, string> {
  const notes = new Map<string, string>();
  for (const group of namesakes(entries)) {
    const oldest = group.at(-1);
    if (oldest === undefined || !documents.has(oldest.id)) continue;
    for (const { id } of group) {
      if (id === oldest.id || !documents.has(id)) continue;
      const words = differenceWords(differences(documents.get(oldest.id), documents.get(id)));
      notes.set(id, words ?? "the same document");
    }
  }
  return notes;
}
