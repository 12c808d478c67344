/** Lists: asked for again and again, their older entries on demand. */

import type { Problem } from "../api.ts";
import { changedPage, mergePages, type Page } from "../lib/shell/pages.ts";
import type { EntryChange } from "../wire.ts";
import { answerTo, type Loadable } from "./loadable.ts";
import type { Part } from "./store.ts";

/** A list that comes page by page. */
export interface PagedList {
  reload(): Promise<void>;
  /** Other entries are looked for: those shown give way when these come. */
  renew(): Promise<void>;
  loadOlder(): Promise<void>;
}

export interface EntryList extends PagedList {
  /** Removes an entry for good. */
  remove(id: string): Promise<void>;
  /** Renames or archives an entry; why it couldn't be. */
  change(id: string, change: EntryChange): Promise<Problem | null>;
}

/** How the service is asked about a list. */
interface EntryQuestions<T> {
  page(cursor: string | null): Promise<Page<T>>;
  remove(id: string): Promise<unknown>;
  change(id: string, change: EntryChange): Promise<T>;
  /** Whether the list shows it, as it is looked at now. */
  isListed(entry: T): boolean;
}

type ListPart<T> = Part<Loadable<Page<T>>>;

export function createPagedList<T extends { id: string }>(list: ListPart<T>, ask: (cursor: string | null) => Promise<Page<T>>): PagedList {
  /** How often other entries were looked for, and of which time those shown are. */
  let looked = 0;
  let shownOf = 0;

  /** Asks for a page and puts it together with what is shown when it comes. */
  async function load(cursor: string | null, together: (page: Page<T>, shown: Page<T>) => Page<T>): Promise<void> {
    const mine = looked;
    const answer = await answerTo(ask(cursor));
    if (mine !== looked) return;
    const shown = list.get();
    const both = answer.status === "ready" && shown.status === "ready" && shownOf === mine;
    list.set(both ? { status: "ready", value: together(answer.value, shown.value) } : answer);
    shownOf = mine;
  }

  async function loadOlder(): Promise<void> {
    const shown = list.get();
    if (shown.status !== "ready" || shown.value.next_cursor === null || shownOf !== looked) return;
    await load(shown.value.next_cursor, (older, newer) => mergePages(older, newer));
  }

  const reload = () => load(null, (newer, older) => mergePages(older, newer));

  function renew(): Promise<void> {
    looked += 1;
    return reload();
  }

  return { reload, renew, loadOlder };
}

/** One whose entries can be renamed, archived and removed. */
export function createEntryList<T extends { id: string }>(list: ListPart<T>, ask: EntryQuestions<T>): EntryList {
  const paged = createPagedList(list, ask.page);

  /** An entry beyond the first page isn't in the next answer. */
  function show(id: string, changed: T | null): void {
    const shown = list.get();
    if (shown.status === "ready") list.set({ status: "ready", value: changedPage(shown.value, id, changed) });
  }

  async function remove(id: string): Promise<void> {
    const answer = await answerTo(ask.remove(id));
    if (answer.status === "failed") return list.set(answer);
    show(id, null);
    await paged.reload();
  }

  async function change(id: string, change: EntryChange): Promise<Problem | null> {
    const answer = await answerTo(ask.change(id, change));
    if (answer.status === "failed") return answer.problem;
    show(id, ask.isListed(answer.value) ? answer.value : null);
    void paged.reload();
    return null;
  }

  return { ...paged, remove, change };
}
