/** Keeps the sweep in view up to date by polling, and its comparison with it. */

import * as api from "../api.ts";
import { isOver } from "../lib/study/point-progress.ts";
import { openSweep, type OpenSweep, type Store } from "./app-state.ts";
import type { SweepDetail } from "../sweep-types.ts";

const POLL_MS = 2000;
/** While designs are at work, a comparison may take one part in so many of the time: the service reads every result for it. */
const REST = 10;

export interface SweepFollower {
  /** Opens a sweep; one that is open takes the baseline of the address. */
  open(id: string): void;
  close(): void;
  /** Asks again from the start, after a failure. */
  reopen(): void;
  /** Takes over what the service answered to a change. */
  take(id: string, detail: SweepDetail): void;
}

export function createSweepFollower(store: Store, onOver: () => void): SweepFollower {
  let timer: number | null = null;
  let comparing = false;
  /** What the comparison in view was made of. */
  let compared = "";
  let comparedFrom: string | null = null;
  let restUntil_ms = 0;

  const isOpen = (id: string): boolean => store.get().openSweep?.id === id;

  function change(id: string, edit: (sweep: OpenSweep) => OpenSweep): void {
    store.update((state) =>
      state.openSweep?.id === id ? { ...state, openSweep: edit(state.openSweep) } : state,
    );
  }

  function open(id: string): void {
    if (isOpen(id)) return void compareIfStale();
    close();
    store.update((state) => ({ ...state, openSweep: openSweep(id) }));
    void load(id);
  }

  function close(): void {
    endPolling();
    [compared, comparedFrom, restUntil_ms] = ["", null, 0];
    store.update((state) => (state.openSweep === null ? state : { ...state, openSweep: null }));
  }

  function reopen(): void {
    const id = store.get().openSweep?.id;
    if (id === undefined) return;
    close();
    open(id);
  }

  function endPolling(): void {
    if (timer !== null) window.clearTimeout(timer);
    timer = null;
  }

  async function load(id: string): Promise<void> {
    try {
      take(id, await api.sweep(id));
    } catch (error) {
      change(id, (sweep) =>
        sweep.detail.status === "ready"
          ? { ...sweep, lost: true }
          : { ...sweep, detail: { status: "failed", problem: api.problemOf(error) } },
      );
      pollUnlessOver(id);
    }
  }

  function take(id: string, detail: SweepDetail): void {
    const before = store.get().openSweep?.detail;
    if (isOver(detail.state) && before?.status === "ready" && !isOver(before.value.state)) onOver();
    change(id, (sweep) => ({ ...sweep, detail: { status: "ready", value: detail }, lost: false }));
    pollUnlessOver(id);
    void compareIfStale();
  }

  function pollUnlessOver(id: string): void {
    const sweep = store.get().openSweep;
    if (sweep?.id !== id || sweep.detail.status !== "ready" || isOver(sweep.detail.value.state)) return;
    endPolling();
    timer = window.setTimeout(() => {
      if (document.visibilityState === "visible") void load(id);
      else pollUnlessOver(id);
    }, POLL_MS);
  }

  /** Asks for the comparison when there are more results than it has, or another baseline is chosen. */
  async function compareIfStale(): Promise<void> {
    const { openSweep: sweep, route } = store.get();
    if (comparing || sweep === null || sweep.detail.status !== "ready") return;
    const { id, detail } = sweep;
    const baseline = baselineOf(detail.value, route.view === "sweep" ? route.baseline : null);
    const results = resultsOf(detail.value);
    const urgent = compared === "" || baseline !== comparedFrom || isOver(detail.value.state);
    if (results === "" || (results === compared && baseline === comparedFrom)) return;
    if (!urgent && Date.now() < restUntil_ms) return;
    comparing = true;
    [compared, comparedFrom] = [results, baseline];
    const begun_ms = Date.now();
    await loadComparison(id, baseline);
    restUntil_ms = Date.now() + REST * (Date.now() - begun_ms);
    comparing = false;
    // The baseline may have been changed meanwhile, or the sweep.
    void compareIfStale();
  }

  async function loadComparison(id: string, baseline: string | null): Promise<void> {
    change(id, (sweep) => ({ ...sweep, comparison: sweep.comparison ?? { status: "loading" } }));
    try {
      const value = await api.comparison(id, baseline);
      change(id, (sweep) => ({ ...sweep, comparison: { status: "ready", value } }));
    } catch (error) {
      change(id, (sweep) => ({ ...sweep, comparison: { status: "failed", problem: api.problemOf(error) } }));
    }
  }

  return { open, close, reopen, take };
}

/** The designs that have a result, as one text. */
function resultsOf(sweep: SweepDetail): string {
  const done = sweep.designs.filter(({ study }) => study.state === "done");
  return done.map(({ study }) => study.id).join(" ");
}

/** The baseline asked for; null, for the first design that has a result, when it is none of the sweep's. */
function baselineOf(sweep: SweepDetail, wanted: string | null): string | null {
  return sweep.designs.some(({ study }) => study.id === wanted) ? wanted : null;
}
