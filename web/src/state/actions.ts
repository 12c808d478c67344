/** Everything that changes the state: the reader's choices, and what the service answers. */

import * as api from "../api.ts";
import { formatRoute, parseRoute, type Route } from "../lib/route.ts";
import { createBrowsing, type BrowsingActions } from "./browsing.ts";
import { createDraftCheck } from "./draft/draft-check.ts";
import { createEntryList, createPagedList, type EntryList, type PagedList } from "./entry-list.ts";
import { createForcesDraft, type ForcesDraftActions } from "./forces/forces-draft.ts";
import { createOpenEstimator, type OpenEstimatorActions } from "./forces/open-estimator.ts";
import { createOpenComparison, type OpenComparisonActions } from "./open-comparison.ts";
import { createOpenStudy, type OpenStudyActions } from "./open-study.ts";
import { createOpenSweep, type OpenSweepActions } from "./open-sweep.ts";
import { partOf, type Store } from "./store.ts";
import type { StudySummary, SweepSummary } from "../wire.ts";
import { createStudyDraft, type StudyDraftActions } from "./draft/study-draft.ts";
import { createStudyPreview } from "./draft/study-preview.ts";
import { createSweepDraft, type SweepDraftActions } from "./draft/sweep-draft.ts";

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
  openComparison: OpenComparisonActions;
  browsing: BrowsingActions;
  estimators: PagedList;
  forcesDraft: ForcesDraftActions;
  openEstimator: OpenEstimatorActions;
}

export function createActions(store: Store): Actions {
  const wanted = (): api.Wanted => store.get().browsing.wanted;
  const isListed = ({ archived }: { archived?: string | null }): boolean => (archived != null) === wanted().archived;
  const studies = createEntryList<StudySummary>(partOf(store, "studies"), {
    page: (cursor) => api.studies(wanted(), cursor),
    remove: api.removeStudy,
    change: async (id, change) => {
      const changed = await api.changeStudy(id, change);
      openStudy.refresh(id);
      return changed;
    },
    isListed,
  });
  const sweeps = createEntryList<SweepSummary>(partOf(store, "sweeps"), {
    page: (cursor) => api.sweeps(wanted(), cursor),
    remove: api.removeSweep,
    change: async (id, change) => {
      const changed = await api.changeSweep(id, change);
      openSweep.refresh(id);
      return changed;
    },
    isListed,
  });
  const check = createDraftCheck(store);
  const preview = createStudyPreview(store);
  const studyDraft = createStudyDraft(store, (route) => go(route, studies), lookAtDraft);
  const sweepDraft = createSweepDraft(store, (route) => go(route, sweeps));
  const openStudy = createOpenStudy(store, () => void studies.reload());
  const openComparison = createOpenComparison(store);
  const renew = async (): Promise<void> => {
    await Promise.all([studies.renew().then(tellApart), sweeps.renew()]);
  };
  const browsing = createBrowsing(store, renew, ({ kind, id }) => void { studies, sweeps }[kind].remove(id));
  const openSweep = createOpenSweep(store, () => void sweeps.reload());

  const estimators = createPagedList(partOf(store, "estimators"), api.estimators);
  const forcesDraft = createForcesDraft(store, (route) => go(route, estimators));
  const openEstimator = createOpenEstimator(store, () => void estimators.reload());

  /** To what was submitted; its list has a new entry. */
  function go(route: Route, list: PagedList): void {
    void list.reload();
    location.hash = formatRoute(route);
  }

  /** Checks and solves what is written, as long as somebody is at it. */
  function lookAtDraft(): void {
    if (store.get().route.view !== "home") return;
    check.look();
    preview.look();
  }

  function showRoute(route: Route): void {
    store.update((state) => ({ ...state, route }));
    if (route.view === "study") openStudy.open(route.id);
    else openStudy.close();
    if (route.view === "sweep") openSweep.open(route.id);
    else openSweep.close();
    if (route.view === "compare") openComparison.open(route);
    else openComparison.close();
    if (route.view === "estimator") openEstimator.open(route.id);
    else openEstimator.close();
    if (route.view === "forces") void estimators.reload();
    if (route.view !== "home") return;
    if (store.get().presets.status !== "ready") void studyDraft.reloadPresets();
    studyDraft.showOrigin(route);
    lookAtDraft();
  }

  function adjust(route: Route): void {
    history.replaceState(null, "", formatRoute(route));
    showRoute(route);
  }

  function tellApart(): Promise<void> {
    return browsing.tellApart();
  }

  function reloadLists(): void {
    void studies.reload().then(tellApart);
    void sweeps.reload();
    if (store.get().route.view === "forces") void estimators.reload();
  }

  function start(): void {
    window.addEventListener("hashchange", () => showRoute(parseRoute(location.hash)));
    reloadLists();
    showRoute(parseRoute(location.hash));
    window.setInterval(() => store.update((state) => ({ ...state, now_ms: Date.now() })), CLOCK_MS);
    window.setInterval(() => {
      if (document.visibilityState === "visible") reloadLists();
    }, LIST_REFRESH_MS);
  }

  return { start, adjust, studies, sweeps, studyDraft, sweepDraft, openStudy, openSweep, openComparison, browsing, estimators, forcesDraft, openEstimator };
}
