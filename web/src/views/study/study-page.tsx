import { againRoute, formatRoute, sweepRoute, type StudyRoute } from "../../lib/route.ts";
import { isOver } from "../../lib/study/point-progress.ts";
import type { Actions } from "../../state/actions.ts";
import type { AppState, OpenStudy } from "../../state/app-state.ts";
import { isMissing, type Loadable } from "../../state/loadable.ts";
import type { StudyDetail, StudyResult } from "../../wire.ts";
import { Loaded } from "../shared/loaded.tsx";
import { Removed } from "../shell/missing.tsx";
import { StateBadge } from "../shared/state-badge.tsx";
import { DocumentPanel } from "./run/document-panel.tsx";
import { StudyProgress } from "./run/study-progress.tsx";
import { SectionBody, SectionLinks } from "./study-sections.tsx";

interface Props {
  state: AppState;
  route: StudyRoute;
  actions: Actions;
}

/** One study: its progress while it runs, its answer when it is done. */
export function StudyPage({ state, route, actions }: Props) {
  const open = state.openStudy;
  if (open === null || open.detail.status === "loading") {
    return (
      <>
        <h1>Study</h1>
        <p class="quiet" role="status">
          Loading the study …
        </p>
      </>
    );
  }
  if (isMissing(open.detail)) return <Removed what="Study" problem={open.detail.problem} />;
  return (
    <Loaded of={open.detail} what="the study" onRetry={actions.openStudy.reopen}>
      {(study) => (
        <article>
          <header class="study-head">
            <h1>{study.name}</h1>
            <StateBadge state={open.progress?.state ?? study.state} />
            <a class="run-again" href={formatRoute(againRoute(study.id))}>
              Run again with changes
            </a>
          </header>
          {study.sweep != null && (
            <p class="provenance">
              A design of <a href={formatRoute(sweepRoute(study.sweep))}>a sweep</a>, beside the others there.
            </p>
          )}
          <Body study={study} open={open} now_ms={state.now_ms} route={route} actions={actions} />
        </article>
      )}
    </Loaded>
  );
}

function Body(props: { study: StudyDetail; open: OpenStudy; now_ms: number; route: Props["route"]; actions: Actions }) {
  const { study, open, now_ms, route, actions } = props;
  const progress = open.progress;
  if (progress === null) return null;
  if (!isOver(progress.state) || open.result === null) {
    return (
      <>
        <StudyProgress open={open} progress={progress} now_ms={now_ms} onCancel={() => void actions.openStudy.cancel()} />
        {isOver(progress.state) && <DocumentPanel study={study} />}
      </>
    );
  }
  return (
    <Loaded of={open.result} what="the result" onRetry={actions.openStudy.reopen}>
      {(result) => (
        <>
          <SectionLinks route={route} />
          <Loaded of={wholeFor(route, open)} what="the map" onRetry={() => void actions.openStudy.loadMap()}>
            {(whole) => <SectionBody study={study} result={whole ?? result} trade={open.trade} route={route} onAdjust={actions.adjust} />}
          </Loaded>
        </>
      )}
    </Loaded>
  );
}

/** The result with its map where the section shows that; most of the document is the map, and other sections do without. */
function wholeFor({ section }: StudyRoute, { whole }: OpenStudy): Loadable<StudyResult | null> {
  if (section !== "tire") return { status: "ready", value: null };
  return whole ?? { status: "loading" };
}
