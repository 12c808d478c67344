/** Everything that changes the state: the reader's choices, and what the service answers. */

import * as api from "../api.ts";
import { parseDraft, withAccuracy, type Accuracy } from "../lib/document/draft.ts";
import { formatRoute, parseRoute, studyRoute, type Route } from "../lib/route.ts";
import { draftOf, mergeLists, newKey, type Draft, type Store } from "./app-state.ts";
import { createFollower } from "./study-follower.ts";
import { createSweepActions, type SweepActions } from "./sweep-actions.ts";

const LIST_REFRESH_MS = 4000;
const CLOCK_MS = 1000;

export interface Actions extends SweepActions {
  start(): void;
  go(route: Route): void;
  /** Changes what a view shows without a new entry in the browser's history. */
  adjust(route: Route): void;
  choosePreset(name: string): void;
  editDraft(text: string): void;
  setAccuracy(accuracy: Accuracy): void;
  submitDraft(): Promise<void>;
  reloadList(): Promise<void>;
  loadOlder(): Promise<void>;
  reloadPresets(): Promise<void>;
  reopen(): void;
  cancelStudy(): Promise<void>;
}

export function createActions(store: Store): Actions {
  const follower = createFollower(store, () => void reloadList());
  const sweeps = createSweepActions(store, go);
  const setDraft = (change: Partial<Draft>): void =>
    store.update((state) => ({ ...state, draft: { ...state.draft, ...change } }));

  function showRoute(route: Route): void {
    store.update((state) => ({ ...state, route }));
    if (route.view === "study") follower.open(route.id);
    else follower.close();
    if (route.view === "sweep") sweeps.openSweep(route.id);
    else sweeps.closeSweep();
    if (route.view === "home" && route.preset !== null && route.preset !== store.get().draft.preset) choosePreset(route.preset);
  }

  function go(route: Route): void {
    location.hash = formatRoute(route);
  }

  function adjust(route: Route): void {
    history.replaceState(null, "", formatRoute(route));
    showRoute(route);
  }

  async function reloadList(): Promise<void> {
    try {
      const page = await api.studies(null);
      store.update((state) => ({
        ...state,
        list: { status: "ready", value: state.list.status === "ready" ? mergeLists(state.list.value, page) : page },
      }));
    } catch (error) {
      store.update((state) => ({ ...state, list: { status: "failed", problem: api.problemOf(error) } }));
    }
  }

  async function loadOlder(): Promise<void> {
    const { list } = store.get();
    if (list.status !== "ready" || list.value.next_cursor === null) return;
    try {
      const older = await api.studies(list.value.next_cursor);
      const studies = [...list.value.studies, ...older.studies];
      store.update((state) => ({
        ...state,
        list: { status: "ready", value: { studies, next_cursor: older.next_cursor } },
      }));
    } catch (error) {
      store.update((state) => ({ ...state, list: { status: "failed", problem: api.problemOf(error) } }));
    }
  }

  async function reloadPresets(): Promise<void> {
    try {
      const value = await api.presets();
      store.update((state) => ({ ...state, presets: { status: "ready", value } }));
      const { route, draft } = store.get();
      const wanted = route.view === "home" ? route.preset : null;
      const name = wanted ?? draft.preset ?? value.studies[0]?.name;
      if (name !== undefined && draft.text === "") choosePreset(name);
    } catch (error) {
      store.update((state) => ({ ...state, presets: { status: "failed", problem: api.problemOf(error) } }));
    }
  }

  function choosePreset(name: string): void {
    const { presets } = store.get();
    const preset = presets.status === "ready" ? presets.value.studies.find((entry) => entry.name === name) : undefined;
    if (preset !== undefined) store.update((state) => ({ ...state, draft: draftOf(preset.name, preset.document) }));
  }

  async function submitDraft(): Promise<void> {
    const { draft } = store.get();
    const parsed = parseDraft(draft.text);
    if ("fault" in parsed) {
      setDraft({ problem: { title: "The document can't be read.", status: 0, detail: parsed.fault.detail } });
      return;
    }
    setDraft({ sending: true, problem: null });
    try {
      const { id } = await api.submit(parsed.document, draft.idempotencyKey);
      setDraft({ sending: false, idempotencyKey: newKey() });
      void reloadList();
      go(studyRoute(id));
    } catch (error) {
      setDraft({ sending: false, problem: api.problemOf(error) });
    }
  }

  async function cancelStudy(): Promise<void> {
    const id = store.get().open?.id;
    if (id === undefined) return;
    try {
      await api.cancel(id);
      follower.refresh();
      void reloadList();
    } catch (error) {
      const cancelProblem = api.problemOf(error);
      store.update((state) => (state.open?.id === id ? { ...state, open: { ...state.open, cancelProblem } } : state));
    }
  }

  function start(): void {
    window.addEventListener("hashchange", () => showRoute(parseRoute(location.hash)));
    void reloadPresets();
    void reloadList();
    void sweeps.reloadSweeps();
    showRoute(parseRoute(location.hash));
    window.setInterval(() => store.update((state) => ({ ...state, now_ms: Date.now() })), CLOCK_MS);
    window.setInterval(() => {
      if (document.visibilityState !== "visible") return;
      void reloadList();
      void sweeps.reloadSweeps();
    }, LIST_REFRESH_MS);
  }

  const editDraft = (text: string): void => setDraft({ text, problem: null, idempotencyKey: newKey() });
  const setAccuracy = (accuracy: Accuracy): void => editDraft(withAccuracy(store.get().draft.text, accuracy));
  return {
    ...sweeps, start, go, adjust, choosePreset, editDraft, setAccuracy, submitDraft, reloadList, loadOlder, reloadPresets,
    reopen: follower.reopen, cancelStudy,
  };
}
