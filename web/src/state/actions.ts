/** Everything that changes the state: the reader's choices, and what the service answers. */

import * as api from "../api.ts";
import { formatRoute, parseRoute, type Route } from "../lib/route.ts";
import { createEntryList, type EntryList } from "./entry-list.ts";
import { createOpenStudy, type OpenStudyActions } from "./open-study.ts";
import { createOpenSweep, type OpenSweepActions } from "./open-sweep.ts";
import { partOf, type Store } from "./store.ts";
import { createStudyDraft, type StudyDraftActions } from "./study-draft.ts";
import { createSweepDraft, type SweepDraftActions } from "./sweep-draft.ts";

const LIST_REFRESH_MS = 4000;
const CLOCK_MS = 1000;

/** By the part of the state that they change. */
export interface Actions {
  start(): void;
  /** Changes what a view shows without a new entry in the browser's history. */
  adjust(route: Route): void;
  studies: EntryList;
  sweeps: EntryList;
  studyDraft: StudyDraftActions;
  sweepDraft: SweepDraftActions;
  openStudy: OpenStudyActions;
  openSweep: OpenSweepActions;
}

export function createActions(store: Store): Actions {
  const studies = createEntryList(partOf(store, "studies"), api.studies, api.removeStudy);
  const sweeps = createEntryList(partOf(store, "sweeps"), api.sweeps, api.removeSweep);
  const studyDraft = createStudyDraft(store, (route) => go(route, studies));
  const sweepDraft = createSweepDraft(store, (route) => go(route, sweeps));
  const openStudy = createOpenStudy(store, () => void studies.reload());
  const openSweep = createOpenSweep(store, () => void sweeps.reload());

  /** To what was submitted; its list has a new entry. */
  function go(route: Route, list: EntryList): void {
    void list.reload();
    location.hash = formatRoute(route);
  }

  function showRoute(route: Route): void {
    store.update((state) => ({ ...state, route }));
    if (route.view === "study") openStudy.open(route.id);
    else openStudy.close();
    if (route.view === "sweep") openSweep.open(route.id);
    else openSweep.close();
    if (route.view === "home") studyDraft.showPreset(route.preset);
  }

  function adjust(route: Route): void {
    history.replaceState(null, "", formatRoute(route));
    showRoute(route);
  }

  function reloadLists(): void {
    void studies.reload();
    void sweeps.reload();
  }

  function start(): void {
    window.addEventListener("hashchange", () => showRoute(parseRoute(location.hash)));
    void studyDraft.reloadPresets();
    reloadLists();
    showRoute(parseRoute(location.hash));
    window.setInterval(() => store.update((state) => ({ ...state, now_ms: Date.now() })), CLOCK_MS);
    window.setInterval(() => {
      if (document.visibilityState === "visible") reloadLists();
    }, LIST_REFRESH_MS);
  }

  return { start, adjust, studies, sweeps, studyDraft, sweepDraft, openStudy, openSweep };
}
