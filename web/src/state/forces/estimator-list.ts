/** All estimators of forces: asked for again and again while their page is open. */

import * as api from "../../api.ts";
import { mergePages } from "../../lib/shell/pages.ts";
import { answerTo } from "../loadable.ts";
import { partOf, type Store } from "../store.ts";

export interface EstimatorListActions {
  reload(): Promise<void>;
  loadOlder(): Promise<void>;
}

export function createEstimatorList(store: Store): EstimatorListActions {
  const list = partOf(store, "estimators");

  async function reload(): Promise<void> {
    const answer = await answerTo(api.estimators(null));
    const shown = list.get();
    const both = answer.status === "ready" && shown.status === "ready";
    list.set(both ? { status: "ready", value: mergePages(shown.value, answer.value) } : answer);
  }

  async function loadOlder(): Promise<void> {
    const shown = list.get();
    if (shown.status !== "ready" || shown.value.next_cursor === null) return;
    const answer = await answerTo(api.estimators(shown.value.next_cursor));
    const now = list.get();
    if (answer.status === "failed" || now.status !== "ready") return list.set(answer);
    list.set({ status: "ready", value: mergePages(answer.value, now.value) });
  }

  return { reload, loadOlder };
}
