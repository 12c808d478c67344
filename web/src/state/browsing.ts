/** What its reader looks for and ticks in the lists, and the documents of studies whose names alone don't tell them apart. */

import * as api from "../api.ts";
import { createNewestWaits } from "../lib/document/newest-waits.ts";
import { namesakes } from "../lib/study/progress/namesakes.ts";
import type { Browsing, Moved } from "./app-state.ts";
import { answerTo } from "./loadable.ts";
import { partOf, type Store } from "./store.ts";

/** As many as one table and one plot still tell apart. */
const MOST_COMPARED = 50;
/** Documents that are asked for at a time; the list comes again in seconds. */
const MOST_ASKED = 8;
/** Long enough that a word is typed in one go. */
const PAUSE_MS = 250;

export interface BrowsingActions {
  /** Looks for this shortly after the last letter. */
  search(text: string): void;
  /** Shows archived entries, or the others. */
  showArchived(on: boolean): void;
  /** An entry has left its list. */
  tellMoved(moved: Moved): void;
  /** That was undone. */
  takeBack(moved: Moved): void;
  /** It stays so: what was removed goes for good. */
  leave(moved: Moved): void;
  tick(id: string, on: boolean): void;
  /** The list of studies has changed. */
  tellApart(): Promise<void>;
}

export function createBrowsing(store: Store, renew: () => Promise<void>, remove: (moved: Moved) => void): BrowsingActions {
  const browsing = partOf(store, "browsing");
  const set = (change: Partial<Browsing>): void => browsing.set({ ...browsing.get(), ...change });
  const asked = new Set<string>();

  const questions = createNewestWaits(async (wanted: api.Wanted) => {
    set({ wanted });
    await renew();
  });
  let timer: number | null = null;

  function look(archived: boolean): void {
    if (timer !== null) window.clearTimeout(timer);
    timer = null;
    questions.offer({ search: browsing.get().search.trim(), archived });
  }

  function search(text: string): void {
    set({ search: text });
    if (timer !== null) window.clearTimeout(timer);
    timer = window.setTimeout(() => look(browsing.get().wanted.archived), PAUSE_MS);
  }

  function tick(id: string, on: boolean): void {
    const others = browsing.get().ticked.filter((each) => each !== id);
    set({ ticked: on ? [...others, id].slice(-MOST_COMPARED) : others });
  }

  async function tellApart(): Promise<void> {
    const { studies } = store.get();
    if (studies.status !== "ready") return;
    const missing = namesakes(studies.value.entries)
      .flat()
      .filter(({ id }) => !asked.has(id))
      .slice(0, MOST_ASKED);
    missing.forEach(({ id }) => asked.add(id));
    for (const { id } of missing) {
      const answer = await answerTo(api.study(id));
      if (answer.status === "ready") set({ documents: new Map(browsing.get().documents).set(id, answer.value.document) });
    }
  }

  function tellMoved(moved: Moved): void {
    const removed = browsing.get().moved.filter(({ to }) => to === "nowhere");
    set({ moved: [...removed, moved] });
    if (moved.to === "nowhere") tick(moved.id, false);
  }

  const takeBack = (moved: Moved): void => set({ moved: browsing.get().moved.filter((other) => other !== moved) });

  function leave(moved: Moved): void {
    if (moved.to === "nowhere") remove(moved);
    takeBack(moved);
  }

  window.addEventListener("pagehide", () => browsing.get().moved.forEach(leave));

  return { search, showArchived: look, tellMoved, takeBack, leave, tick, tellApart };
}
