/** The sweep in view and its comparison, kept up to date by polling. */

import * as api from "../api.ts";
import { isOver } from "../lib/study/point-progress.ts";
import { designsOf } from "../lib/sweep/design-progress.ts";
import type { SweepDetail } from "../wire.ts";
import { openedSweep, type OpenSweep } from "./app-state.ts";
import { createInView, createPolling, type InView } from "./in-view.ts";
import { answerTo } from "./loadable.ts";
import { partOf, type Store } from "./store.ts";

const POLL_MS = 2000;
/** While designs are at work, a comparison may take one part in so many of the time: the service reads every result for it. */
const REST = 10;

export interface OpenSweepActions extends Pick<InView<OpenSweep>, "open" | "close" | "reopen"> {
  cancel(): Promise<void>;
  resume(): Promise<void>;
  /** Asks for this sweep again, if it is the one in view. */
  refresh(id: string): void;
}

export function createOpenSweep(store: Store, onChanged: () => void): OpenSweepActions {
  const inView = createInView(partOf(store, "openSweep"), { begin: openedSweep, load, stop });
  const polling = createPolling(load, POLL_MS);
  let comparing = false;
  /** How many results the comparison in view was made of. */
  let compared = 0;
  let comparedFrom: string | null = null;
  /** Place of the first design in view. */
  let loadedFrom = 0;
  let restUntil_ms = 0;

  /** One that is open takes the baseline and the designs of the address. */
  function open(id: string): void {
    if (!inView.isOpen(id)) inView.open(id);
    else if (placeOf(store) !== loadedFrom) void load(id);
    else void compareIfStale();
  }

  function stop(): void {
    polling.end();
    [compared, comparedFrom, restUntil_ms] = [0, null, 0];
  }

  async function load(id: string): Promise<void> {
    loadedFrom = placeOf(store);
    const answer = await answerTo(api.sweep(id, loadedFrom));
    if (answer.status === "ready") return take(id, answer.value);
    inView.edit(id, (sweep) => (sweep.detail.status === "ready" ? { ...sweep, lost: true } : { ...sweep, detail: answer }));
    pollUnlessOver(id);
  }

  function take(id: string, detail: SweepDetail): void {
    const before = inView.get()?.detail;
    if (isOver(detail.state) && before?.status === "ready" && !isOver(before.value.state)) onChanged();
    inView.edit(id, (sweep) => ({ ...sweep, detail: { status: "ready", value: detail }, lost: false }));
    pollUnlessOver(id);
    void lookAway(id);
    void compareIfStale();
  }

  /** Asks what other machines do for it. */
  async function lookAway(id: string): Promise<void> {
    const answer = await answerTo(api.engines());
    if (answer.status !== "ready") return;
    const all = answer.value.flatMap((engine) => engine.sweeps.map((sweep) => ({ ...sweep, engine: engine.name })));
    inView.edit(id, (sweep) => ({ ...sweep, away: all.find((one) => one.sweep === id) ?? null }));
  }

  function pollUnlessOver(id: string): void {
    const sweep = inView.get();
    if (sweep?.id === id && sweep.detail.status === "ready" && !isOver(sweep.detail.value.state)) polling.again(id);
  }

  /** Asks for the comparison when there are more results than it has, or another baseline is chosen. */
  async function compareIfStale(): Promise<void> {
    const { openSweep: sweep, route } = store.get();
    if (comparing || sweep === null || sweep.detail.status !== "ready") return;
    const { id, detail } = sweep;
    const baseline = baselineOf(detail.value, route.view === "sweep" ? route.baseline : null);
    const results = detail.value.counts.done;
    const urgent = compared === 0 || baseline !== comparedFrom || isOver(detail.value.state);
    if (results === 0 || (results === compared && baseline === comparedFrom)) return;
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
    inView.edit(id, (sweep) => ({ ...sweep, comparison: sweep.comparison ?? { status: "loading" } }));
    const comparison = await answerTo(api.comparison(id, baseline));
    inView.edit(id, (sweep) => ({ ...sweep, comparison }));
  }

  /** Changes the sweep in view and takes over how it then stands. */
  async function ask(question: (id: string) => Promise<SweepDetail>): Promise<void> {
    const id = inView.get()?.id;
    if (id === undefined) return;
    inView.edit(id, (sweep) => ({ ...sweep, problem: null }));
    const answer = await answerTo(question(id));
    if (answer.status === "failed") return inView.edit(id, (sweep) => ({ ...sweep, problem: answer.problem }));
    await load(id);
    onChanged();
  }

  const { close, reopen } = inView;
  return { open, close, reopen, cancel: () => ask(api.cancelSweep), resume: () => ask(api.resumeSweep), refresh: (id) => void (inView.isOpen(id) && load(id)) };
}

/** The place of the first design that the address asks for. */
function placeOf(store: Store): number {
  const { route } = store.get();
  return route.view === "sweep" ? route.from : 0;
}

/** The baseline asked for; null, for the first design that has a result, when it is none of the sweep's. */
function baselineOf(sweep: SweepDetail, wanted: string | null): string | null {
  const isInView = sweep.designs.some(({ study }) => study.id === wanted);
  // One of those that aren't in view may be it.
  return isInView || sweep.designs.length < designsOf(sweep) ? wanted : null;
}
