import { formatRoute, sweepRoute, type StudyRoute } from "../../lib/route.ts";
import { isOver } from "../../lib/study/point-progress.ts";
import type { Actions } from "../../state/actions.ts";
import type { AppState, OpenStudy } from "../../state/app-state.ts";
import { Loaded } from "../shared/loaded.tsx";
import { StateBadge } from "../shared/state-badge.tsx";
import { ResultPanels } from "./result-panels.tsx";
import { StudyProgress } from "./study-progress.tsx";

interface Props {
  state: AppState;
  route: StudyRoute;
  actions: Actions;
}

/** One study: its progress while it runs, its answer when it is done. */
export function StudyPage({ state, route, actions }: Props) {
  const open = state.openStudy;
  if (open === null) return <p class="quiet">Loading the study …</p>;
  return (
    <Loaded of={open.detail} what="the study" onRetry={actions.openStudy.reopen}>
      {(study) => (
        <article class="study">
          <header class="study-head">
            <h1>{study.name}</h1>
            <StateBadge state={open.progress?.state ?? study.state} />
          </header>
          {study.sweep != null && (
            <p class="provenance">
              A design of <a href={formatRoute(sweepRoute(study.sweep))}>a sweep</a>, beside the others there.
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
    return <StudyProgress open={open} progress={progress} now_ms={now_ms} onCancel={() => void actions.openStudy.cancel()} />;
  }
  return (
    <Loaded of={open.result} what="the result" onRetry={actions.openStudy.reopen}>
      {(result) => <ResultPanels result={result} trade={open.trade} route={route} onAdjust={actions.adjust} />}
    </Loaded>
  );
}
