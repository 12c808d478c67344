/** The estimator in view: followed by polling to its end, then its report and the rows that were left out. */

import * as api from "../../api.ts";
import { isOver } from "../../lib/study/point-progress.ts";
import { openedEstimator, type OpenEstimator } from "../app-state.ts";
import { createInView, createPolling, type InView } from "../in-view.ts";
import { answerTo } from "../loadable.ts";
import { partOf, type Store } from "../store.ts";

const POLL_MS = 1000;

export interface OpenEstimatorActions extends Pick<InView<OpenEstimator>, "open" | "close" | "reopen"> {
  cancel(): Promise<void>;
  /** Removes it for good and goes back to the list. */
  remove(): Promise<void>;
}

export function createOpenEstimator(store: Store, onChanged: () => void): OpenEstimatorActions {
  const inView = createInView(partOf(store, "openEstimator"), { begin: openedEstimator, load, stop: () => polling.end() });
  const polling = createPolling(load, POLL_MS);

  async function load(id: string): Promise<void> {
    const answer = await answerTo(api.estimator(id));
    if (answer.status === "failed") {
      inView.edit(id, (open) => (open.detail.status === "ready" ? { ...open, lost: true } : { ...open, detail: answer }));
      return poll(id);
    }
    inView.edit(id, (open) => ({ ...open, detail: answer, lost: false }));
    if (answer.value.state === "done") await loadReport(id);
    else if (!isOver(answer.value.state)) poll(id);
  }

  function poll(id: string): void {
    if (inView.get()?.id === id && inView.get()?.detail.status === "ready") polling.again(id);
  }

  async function loadReport(id: string): Promise<void> {
    inView.edit(id, (open) => ({ ...open, report: { status: "loading" }, leftOut: { status: "loading" } }));
    const report = await answerTo(api.report(id));
    inView.edit(id, (open) => ({ ...open, report }));
    const leftOut = await answerTo(api.leftOut(id));
    inView.edit(id, (open) => ({ ...open, leftOut }));
  }

  /** Asks for something that changes it; whether that was done. */
  async function ask(question: (id: string) => Promise<unknown>): Promise<string | null> {
    const id = inView.get()?.id;
    if (id === undefined) return null;
    inView.edit(id, (open) => ({ ...open, problem: null }));
    const answer = await answerTo(question(id));
    if (answer.status === "failed") {
      inView.edit(id, (open) => ({ ...open, problem: answer.problem }));
      return null;
    }
    onChanged();
    return id;
  }

  async function cancel(): Promise<void> {
    const id = await ask(api.cancelEstimator);
    if (id !== null && inView.isOpen(id)) await load(id);
  }

  async function remove(): Promise<void> {
    const id = await ask(api.removeEstimator);
    if (id !== null && inView.isOpen(id)) location.hash = "#/forces";
  }

  return { open: inView.open, close: inView.close, reopen: inView.reopen, cancel, remove };
}
