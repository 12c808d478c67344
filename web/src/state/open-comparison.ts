/** The studies that are compared: their documents and what differs in their results. */

import * as api from "../api.ts";
import type { CompareRoute } from "../lib/route.ts";
import { openedComparison } from "./app-state.ts";
import { createInView } from "./in-view.ts";
import { answerTo } from "./loadable.ts";
import { partOf, type Store } from "./store.ts";

export interface OpenComparisonActions {
  open(route: CompareRoute): void;
  close(): void;
  reopen(): void;
}

/** Behind the studies the baseline, which may be none of them. */
const SEPARATOR = "|";

export function createOpenComparison(store: Store): OpenComparisonActions {
  const inView = createInView(partOf(store, "openComparison"), { begin: openedComparison, load, stop: () => undefined });

  async function load(id: string): Promise<void> {
    const [list = "", baseline = ""] = id.split(SEPARATOR);
    const studies = list.split(",").filter((study) => study !== "");
    if (studies.length < 2) return;
    const [details, comparison] = await Promise.all([
      answerTo(Promise.all(studies.map(api.study))),
      answerTo(api.studyComparison(studies, baseline === "" ? null : baseline)),
    ]);
    inView.edit(id, (open) => ({ ...open, details, comparison }));
  }

  return {
    open: ({ studies, baseline }) => inView.open(`${studies.join(",")}${SEPARATOR}${baseline ?? ""}`),
    close: inView.close,
    reopen: inView.reopen,
  };
}
