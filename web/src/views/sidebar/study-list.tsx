import type { Actions } from "../../state/actions.ts";
import { moment } from "../../lib/format.ts";
import { isOver, share } from "../../lib/study/point-progress.ts";
import { formatRoute, studyRoute } from "../../lib/route.ts";
import type { AppState } from "../../state/app-state.ts";
import type { StudySummary } from "../../types.ts";
import { Loaded } from "../shared/loaded.tsx";
import { StateBadge } from "../shared/state-badge.tsx";

/** All studies of the database, newest first as the service sends them. */
export function StudyListView({ state, actions }: { state: AppState; actions: Actions }) {
  const openId = state.route.view === "study" ? state.route.id : null;
  return (
    <section>
      <h2>Studies</h2>
      <Loaded of={state.list} what="the studies" onRetry={() => void actions.reloadList()}>
        {(list) =>
          list.studies.length === 0 ? (
            <p class="quiet">No study yet. Pick a preset and run it.</p>
          ) : (
            <>
              <ul class="study-list">
                {list.studies.map((study) => (
                  <Entry key={study.id} study={study} isOpen={study.id === openId} now={new Date(state.now_ms)} />
                ))}
              </ul>
              {list.next_cursor !== null && (
                <button type="button" onClick={() => void actions.loadOlder()}>
                  Show older studies
                </button>
              )}
            </>
          )
        }
      </Loaded>
    </section>
  );
}

function Entry({ study, isOpen, now }: { study: StudySummary; isOpen: boolean; now: Date }) {
  return (
    <li>
      <a href={formatRoute(studyRoute(study.id))} aria-current={isOpen ? "page" : undefined}>
        <span class="study-name">{study.name}</span>
        <span class="study-facts">
          <StateBadge state={study.state} />
          <span>{moment(study.created, now)}</span>
          {study.points_total > 0 && (
            <span>
              {study.points_done}/{study.points_total} points
            </span>
          )}
        </span>
        {!isOver(study.state) && (
          <progress max={1} value={share({ total: study.points_total, done: study.points_done })}>
            {study.points_done} of {study.points_total}
          </progress>
        )}
      </a>
    </li>
  );
}
