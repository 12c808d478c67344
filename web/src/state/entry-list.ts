/** A list of the sidebar: asked for again and again, its older entries on demand. */

import { mergePages, type Page } from "../lib/pages.ts";
import { answerTo, type Loadable } from "./loadable.ts";
import type { Part } from "./store.ts";

export interface EntryList {
  reload(): Promise<void>;
  loadOlder(): Promise<void>;
  /** Removes an entry for good. */
  remove(id: string): Promise<void>;
}

export function createEntryList<T extends { id: string }>(
  list: Part<Loadable<Page<T>>>,
  ask: (cursor: string | null) => Promise<Page<T>>,
  drop: (id: string) => Promise<unknown>,
): EntryList {
  /** Asks for a page and puts it together with what is shown when it comes. */
  async function load(cursor: string | null, together: (page: Page<T>, shown: Page<T>) => Page<T>): Promise<void> {
    const answer = await answerTo(ask(cursor));
    const shown = list.get();
    const both = answer.status === "ready" && shown.status === "ready";
    list.set(both ? { status: "ready", value: together(answer.value, shown.value) } : answer);
  }

  async function loadOlder(): Promise<void> {
    const shown = list.get();
    if (shown.status !== "ready" || shown.value.next_cursor === null) return;
    await load(shown.value.next_cursor, (older, newer) => mergePages(older, newer));
  }

  const reload = () => load(null, (newer, older) => mergePages(older, newer));

  async function remove(id: string): Promise<void> {
    const answer = await answerTo(drop(id));
    if (answer.status === "failed") list.set(answer);
    else await reload();
  }

  return { reload, loadOlder, remove };
}
