/** Lists that the service gives page by page, newest first. */

export interface Page<T> {
  entries: T[];
  /** Where the next older page begins; null behind the last. */
  next_cursor: string | null;
}

/** The newer entries take the place of the older ones down to the last of them: what isn't among them was removed. Identifiers are ordered by time. */
export function mergePages<T extends { id: string }>(older: Page<T>, newer: Page<T>): Page<T> {
  const last = newer.entries.at(-1);
  const rest = last === undefined ? [] : older.entries.filter((entry) => entry.id < last.id);
  return { entries: [...newer.entries, ...rest], next_cursor: rest.length > 0 ? older.next_cursor : newer.next_cursor };
}

/** The page with what became of one of its entries; null where it isn't listed any more. */
export function changedPage<T extends { id: string }>(page: Page<T>, id: string, changed: T | null): Page<T> {
  const entries = page.entries.flatMap((entry) => (entry.id !== id ? [entry] : changed === null ? [] : [changed]));
  return { ...page, entries };
}
