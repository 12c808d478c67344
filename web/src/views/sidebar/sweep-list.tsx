import type { Actions } from "../../state/actions.ts";
import { moment } from "../../lib/format.ts";
import { isOver } from "../../lib/study/point-progress.ts";
import { formatRoute, sweepRoute } from "../../lib/route.ts";
import { designsOf, designsOver } from "../../lib/sweep/design-progress.ts";
import type { AppState } from "../../state/app-state.ts";
import type { SweepSummary } from "../../sweep-types.ts";
import { Loaded } from "../shared/loaded.tsx";
import { StateBadge } from "../shared/state-badge.tsx";

/** The sweeps of the database, newest first as the service sends them; nothing while there is none. */
export function SweepListView({ state, actions }: { state: AppState; actions: Actions }) {
  const openId = state.route.view === "sweep" ? state.route.id : null;
  if (state.sweeps.status === "ready" && state.sweeps.value.sweeps.length === 0) return null;
  return (
    <section>
      <h2>Sweeps</h2>
      <Loaded of={state.sweeps} what="the sweeps" onRetry={() => void actions.reloadSweeps()}>
        {(list) => (
          <>
            <ul class="study-list sweep-list">
              {list.sweeps.map((sweep) => (
                <Entry key={sweep.id} sweep={sweep} isOpen={sweep.id === openId} now={new Date(state.now_ms)} />
              ))}
            </ul>
            {list.next_cursor !== null && (
              <button type="button" onClick={() => void actions.loadOlderSweeps()}>
                Show older sweeps
              </button>
            )}
          </>
        )}
      </Loaded>
    </section>
  );
}

function Entry({ sweep, isOpen, now }: { sweep: SweepSummary; isOpen: boolean; now: Date }) {
  const [over, all] = [designsOver(sweep), designsOf(sweep)];
  return (
    <li>
      <a href={formatRoute(sweepRoute(sweep.id))} aria-current={isOpen ? "page" : undefined}>
        <span class="study-name">{sweep.name}</span>
        <span class="study-facts">
          <StateBadge state={sweep.state} />
          <span>{moment(sweep.created, now)}</span>
          <span>
            {sweep.counts.done}/{all} designs
          </span>
        </span>
        {!isOver(sweep.state) && (
          <progress max={all} value={over}>
            {over} of {all}
          </progress>
        )}
      </a>
    </li>
  );
}
