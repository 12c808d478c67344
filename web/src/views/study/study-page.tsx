import type { Actions } from "../../state/actions.ts";
import { isOver } from "../../lib/study/point-progress.ts";
import { formatRoute, sweepRoute, type Route } from "../../lib/route.ts";
import type { AppState, OpenStudy } from "../../state/app-state.ts";
import { Loaded } from "../shared/loaded.tsx";
import { ProgressView } from "./study-progress.tsx";
import { ResultView } from "./result-panels.tsx";
import { StateBadge } from "../shared/state-badge.tsx";

interface Props {
  state: AppState;
  route: Extract<Route, { view: "study" }>;
  actions: Actions;
}

/** One study: its progress while it runs, its answer when it is done. */
export function StudyView({ state, route, actions }: Props) {
  const open = state.open;
  if (open === null) return <p class="quiet">Loading the study …</p>;
  return (
    <Loaded of={open.summary} what="the study" onRetry={actions.reopen}>
      {(summary) => (
        <article class="study">
          <header class="study-head">
            <h1>{summary.name}</h1>
            <StateBadge state={open.progress?.state ?? summary.state} />
          </header>
          {summary.sweep != null && (
            <p class="provenance">
              A design of <a href={formatRoute(sweepRoute(summary.sweep))}>a sweep</a>, beside the others there.
            </p>
          )}
          <Body open={open} now_ms={state.now_ms} route={route} actions={actions} />
        </article>
      )}
    </Loaded>
  );
}

function Body(props: { open: OpenStudy; now_ms: number; route: Props["route"]; actions: Actions }) {
  const { open, now_ms, route, actions } = props;
  const progress = open.progress;
  if (progress === null) return null;
  if (!isOver(progress.state) || open.result === null) {
    return <ProgressView open={open} progress={progress} now_ms={now_ms} onCancel={() => void actions.cancelStudy()} />;
  }
  return (
    <Loaded of={open.result} what="the result" onRetry={actions.reopen}>
      {(result) => <ResultView result={result} trade={open.trade} route={route} onAdjust={actions.adjust} />}
    </Loaded>
  );
}
