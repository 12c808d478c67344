/** The study in view: kept up to date by its stream, and by polling whenever that is broken. */

import * as api from "../api.ts";
import { advance, fromSummary, isOver, withSummary } from "../lib/study/point-progress.ts";
import type { StudyEvent } from "../lib/study/stream-events.ts";
import type { StudyDetail, StudyResult, Trade } from "../wire.ts";
import { openedStudy, type OpenStudy } from "./app-state.ts";
import { createInView, type InView } from "./in-view.ts";
import { answerTo, type Loadable } from "./loadable.ts";
import { partOf, type Store } from "./store.ts";

const POLL_MS = 2000;

export interface OpenStudyActions extends Pick<InView<OpenStudy>, "open" | "close" | "reopen"> {
  cancel(): Promise<void>;
  /** Asks for this study again, if it is the one in view. */
  refresh(id: string): void;
  /** Asks for the result with its map. */
  loadMap(): Promise<void>;
}

export function createOpenStudy(store: Store, onChanged: () => void): OpenStudyActions {
  const inView = createInView(partOf(store, "openStudy"), { begin: openedStudy, load, stop: endStream });
  let stopStream: (() => void) | null = null;
  let poll: number | null = null;

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
    const answer = await answerTo(api.study(id));
    if (answer.status === "failed") return inView.edit(id, (study) => ({ ...study, detail: answer }));
    takeDetail(id, answer.value);
    if (!inView.isOpen(id)) return;
    if (answer.value.state === "failed") listenForFailures(id);
    if (isOver(answer.value.state)) return;
    stopStream = api.follow(id, {
      open: () => {
        endPolling();
        inView.edit(id, (study) => ({ ...study, link: "live" }));
        // Whatever happened between the entry and the stream.
        refresh();
      },
      lost: () => {
        inView.edit(id, (study) => ({ ...study, link: "polling" }));
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
    const id = inView.get()?.id;
    if (id === undefined) return;
    // A poll that fails is followed by the next; the state says since when they do.
    api.study(id).then(
      (detail) => takeDetail(id, detail),
      () => inView.edit(id, (study) => ({ ...study, lost_ms: study.lost_ms ?? Date.now() })),
    );
  }

  function takeDetail(id: string, detail: StudyDetail): void {
    inView.edit(id, (study) => ({
      ...study,
      lost_ms: null,
      detail: { status: "ready", value: detail },
      progress: study.progress === null ? fromSummary(detail) : withSummary(study.progress, detail),
    }));
    finishIfOver(id);
  }

  function takeEvent(id: string, event: StudyEvent): void {
    const now_ms = Date.now();
    inView.edit(id, (study) => (study.progress === null ? study : { ...study, progress: advance(study.progress, event, now_ms) }));
    // What the study is expected to take is stored when it starts.
    if (event.kind === "started") refresh();
    finishIfOver(id);
  }

  function finishIfOver(id: string): void {
    const study = inView.get();
    if (study === null || study.id !== id || study.progress === null || !isOver(study.progress.state)) return;
    if (study.link === "closed") return;
    endStream();
    inView.edit(id, (open) => ({ ...open, link: "closed" }));
    onChanged();
    refresh();
    if (study.progress.state === "done") void loadResult(id);
  }

  async function loadResult(id: string): Promise<void> {
    inView.edit(id, (study) => ({ ...study, result: { status: "loading" } }));
    const answer = await answerTo(resultAndTrade(id));
    if (answer.status === "failed") return inView.edit(id, (study) => ({ ...study, result: answer }));
    const { result, trade } = answer.value;
    const whole: Loadable<StudyResult> | null = result.map == null ? null : { status: "ready", value: result };
    inView.edit(id, (study) => ({ ...study, result: { status: "ready", value: result }, whole, trade }));
    loadMapIfShown();
  }

  function loadMapIfShown(): void {
    const [{ route }, study] = [store.get(), inView.get()];
    const isShown = route.view === "study" && route.section === "tire";
    if (isShown && study?.result?.status === "ready" && study.whole === null) void loadMap();
  }

  async function loadMap(): Promise<void> {
    const id = inView.get()?.id;
    if (id === undefined) return;
    inView.edit(id, (study) => ({ ...study, whole: { status: "loading" } }));
    const whole = await answerTo(api.result(id, true));
    inView.edit(id, (study) => ({ ...study, whole }));
  }

  async function cancel(): Promise<void> {
    const id = inView.get()?.id;
    if (id === undefined) return;
    const answer = await answerTo(api.cancel(id));
    if (answer.status === "failed") return inView.edit(id, (study) => ({ ...study, problem: answer.problem }));
    refresh();
    onChanged();
  }

  function open(id: string): void {
    if (inView.isOpen(id)) loadMapIfShown();
    else inView.open(id);
  }

  const { close, reopen } = inView;
  return { open, close, reopen, cancel, loadMap, refresh: (id) => void (inView.isOpen(id) && refresh()) };
}

/** The answer of a study without its map, and what accuracy costs where that was measured. */
async function resultAndTrade(id: string): Promise<{ result: StudyResult; trade: Trade | null }> {
  const [result, { trade_measured }] = await Promise.all([api.result(id, false), api.study(id)]);
  return { result, trade: trade_measured ? await api.trade(id) : null };
}
