import { useEffect } from "preact/hooks";
import { countWords } from "../../lib/layouts/layout-words.ts";
import { pageTitle, type Titled } from "../../lib/shell/page/page-title.ts";
import { answersLayout } from "../../lib/study/result-picks.ts";
import type { AppState, OpenStudy } from "../../state/app-state.ts";
import { isMissing } from "../../state/loadable.ts";

/** Names what is open in the browser's tab and history, when it is loaded and when it is renamed. */
export function useTitle(state: AppState): void {
  const title = pageTitle(state.route, titledIn(state));
  useEffect(() => {
    document.title = title;
  }, [title]);
}

function titledIn({ openStudy, openSweep, openEstimator }: AppState): Titled {
  const detail = (openStudy ?? openSweep ?? openEstimator)?.detail;
  return { name: detail?.status === "ready" ? detail.value.name : null, answer: answerOf(openStudy), isMissing: detail !== undefined && isMissing(detail) };
}

function answerOf(study: OpenStudy | null): string | null {
  if (study?.result?.status !== "ready") return null;
  const layout = answersLayout(study.result.value);
  return layout === null ? null : countWords(layout);
}
