/** Lists that the service gives page by page, newest first. */

export interface Page<T> {
  entries: T[];
  /** Where the next older page begins; null behind the last. */
  next_cursor: string | null;
}

/** The newer entries take the place of the older ones; what only the older page has stays behind them. */
export function mergePages<T extends { id: string }>(older: Page<T>, newer: Page<T>): Page<T> {
  const known = new Set(newer.entries.map((entry) => entry.id));
  const rest = older.entries.filter((entry) => !known.has(entry.id));
  return { entries: [...newer.entries, ...rest], next_cursor: rest.length > 0 ? older.next_cursor : newer.next_cursor };
}
