/** Keeps the study in view up to date: by its stream, and by polling whenever the stream is broken. */

import * as api from "../api.ts";
import { advance, fromSummary, isOver, withSummary } from "../lib/study/point-progress.ts";
import { openStudy, type OpenStudy, type Store } from "./app-state.ts";
import type { StudyEvent, StudySummary } from "../types.ts";

const POLL_MS = 2000;

export interface Follower {
  open(id: string): void;
  close(): void;
  /** Asks again from the start, after a failure. */
  reopen(): void;
  /** Asks for the study's entry once. */
  refresh(): void;
}

export function createFollower(store: Store, onOver: () => void): Follower {
  let stopStream: (() => void) | null = null;
  let poll: number | null = null;

  const isOpen = (id: string): boolean => store.get().open?.id === id;

  function change(id: string, edit: (study: OpenStudy) => OpenStudy): void {
    store.update((state) => (state.open?.id === id ? { ...state, open: edit(state.open) } : state));
  }

  function open(id: string): void {
    if (isOpen(id)) return;
    close();
    store.update((state) => ({ ...state, open: openStudy(id) }));
    void load(id);
  }

  function close(): void {
    endStream();
    store.update((state) => (state.open === null ? state : { ...state, open: null }));
  }

  function reopen(): void {
    const id = store.get().open?.id;
    if (id === undefined) return;
    close();
    open(id);
  }

  function endStream(): void {
    stopStream?.();
    stopStream = null;
    endPolling();
  }

  function endPolling(): void {
    if (poll !== null) window.clearInterval(poll);
    poll = null;
  }

  async function load(id: string): Promise<void> {
    let summary: StudySummary;
    try {
      summary = await api.study(id);
    } catch (error) {
      change(id, (study) => ({ ...study, summary: { status: "failed", problem: api.problemOf(error) } }));
      return;
    }
    takeSummary(id, summary);
    if (!isOpen(id)) return;
    if (summary.state === "failed") listenForFailures(id);
    if (isOver(summary.state)) return;
    stopStream = api.follow(id, {
      open: () => {
        endPolling();
        change(id, (study) => ({ ...study, link: "live" }));
        // Whatever happened between the entry and the stream.
        refresh();
      },
      lost: () => {
        change(id, (study) => ({ ...study, link: "polling" }));
        poll ??= window.setInterval(refresh, POLL_MS);
      },
      event: (event) => takeEvent(id, event),
    });
  }

  /** The stream is replayed from the start, and says which points failed and why. */
  function listenForFailures(id: string): void {
    const stop = api.follow(id, {
      open: () => undefined,
      lost: () => stop(),
      event: (event) => {
        takeEvent(id, event);
        if (event.kind === "failed") stop();
      },
    });
    stopStream = stop;
  }

  function refresh(): void {
    const id = store.get().open?.id;
    if (id === undefined) return;
    // A poll that fails is followed by the next; the state says that the page is polling.
    api.study(id).then((summary) => takeSummary(id, summary), () => undefined);
  }

  function takeSummary(id: string, summary: StudySummary): void {
    change(id, (study) => ({
      ...study,
      summary: { status: "ready", value: summary },
      progress: study.progress === null ? fromSummary(summary) : withSummary(study.progress, summary),
    }));
    finishIfOver(id);
  }

  function takeEvent(id: string, event: StudyEvent): void {
    const now_ms = Date.now();
    change(id, (study) =>
      study.progress === null ? study : { ...study, progress: advance(study.progress, event, now_ms) },
    );
    finishIfOver(id);
  }

  function finishIfOver(id: string): void {
    const study = store.get().open;
    if (study === null || study.id !== id || study.progress === null || !isOver(study.progress.state)) return;
    if (study.link === "closed") return;
    endStream();
    change(id, (open) => ({ ...open, link: "closed" }));
    onOver();
    refresh();
    if (study.progress.state === "done") void loadResult(id);
  }

  async function loadResult(id: string): Promise<void> {
    change(id, (study) => ({ ...study, result: { status: "loading" } }));
    try {
      const [value, { trade_measured }] = await Promise.all([api.result(id), api.study(id)]);
      const trade = trade_measured === true ? await api.trade(id) : null;
      change(id, (study) => ({ ...study, result: { status: "ready", value }, trade }));
    } catch (error) {
      change(id, (study) => ({ ...study, result: { status: "failed", problem: api.problemOf(error) } }));
    }
  }

  return { open, close, reopen, refresh };
}
