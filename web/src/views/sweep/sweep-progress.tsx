import { duration, integer } from "../../lib/format.ts";
import { isOver } from "../../lib/study/point-progress.ts";
import { countsText, designsOf, designsOver, designsToResume, sweepSecondsLeft, sweepShare, tasksText } from "../../lib/sweep/design-progress.ts";
import type { Actions } from "../../state/actions.ts";
import type { Away, OpenSweep } from "../../state/app-state.ts";
import type { SweepDetail } from "../../wire.ts";
import { Facts } from "../shared/facts.tsx";
import { ProblemBox } from "../shared/problem-box.tsx";

interface Props {
  open: OpenSweep;
  sweep: SweepDetail;
  actions: Actions;
}

/** How far a sweep is as a whole, with what can be done about it. */
export function SweepProgress({ open, sweep, actions }: Props) {
  return (
    <section class="panel" aria-label="Progress">
      <p role="status">{outcome(sweep, open.away)}</p>
      <progress class="wide" max={1} value={sweepShare(sweep)} aria-label="Designs done">
        {designsOver(sweep)} of {designsOf(sweep)}
      </progress>
      <Standing sweep={sweep} />
      {open.away !== null && <Elsewhere away={open.away} />}
      {open.problem !== null && <ProblemBox problem={open.problem} />}
      {isOver(sweep.state) ? <Resume sweep={sweep} actions={actions} /> : <Cancel open={open} actions={actions} />}
    </section>
  );
}

function outcome(sweep: SweepDetail, away: Away | null): string {
  const { done } = sweep.counts;
  const all = designsOf(sweep);
  if (away?.ended === null && !isOver(sweep.state)) return `Other machines solve the designs, as tasks of ${away.engine}.`;
  switch (sweep.state) {
    case "queued":
      return "Waiting for a free solver.";
    case "running":
      return "Solving the designs, one after the other.";
    case "cancelled":
      return `Cancelled; ${done} of ${all} designs have a result.`;
    default:
      return done === all ? "Done: every design has a result." : `Done; ${done} of ${all} designs have a result.`;
  }
}

function Standing({ sweep }: { sweep: SweepDetail }) {
  const facts: [string, string][] = [
    ["Designs", countsText(sweep)],
    ["Points", `${integer(sweep.points_done)} of ${sweep.points_total == null ? "?" : integer(sweep.points_total)}`],
    ["At work", duration(sweep.worked_s)],
  ];
  if (!isOver(sweep.state)) facts.push(["Time left", duration(sweepSecondsLeft(sweep))]);
  return <Facts facts={facts} />;
}

/** What other machines do, or did. */
function Elsewhere({ away }: { away: Away }) {
  const refused = away.refused.map(({ because }) => because);
  return (
    <>
      <Facts facts={[[`Tasks of ${away.engine}`, tasksText(away)]]} />
      {[...refused, ...away.said].map((words) => (
        <p key={words} class="quiet">
          {words}
        </p>
      ))}
    </>
  );
}

function Cancel({ open, actions }: { open: OpenSweep; actions: Actions }) {
  return (
    <div class="actions">
      <button type="button" onClick={() => void actions.openSweep.cancel()}>
        Cancel sweep
      </button>
      <p class="quiet">Points solved so far stay stored. {open.lost && "The service doesn't answer; asking again every two seconds."}</p>
    </div>
  );
}

function Resume({ sweep, actions }: { sweep: SweepDetail; actions: Actions }) {
  const count = designsToResume(sweep);
  if (count === 0) return null;
  return (
    <div class="actions">
      <button type="button" onClick={() => void actions.openSweep.resume()}>
        Resume {count} {count === 1 ? "design" : "designs"}
      </button>
      <p class="quiet">
        Puts designs that were cancelled or failed back into the queue. What they had solved is kept; a load without an equilibrium stays without one.
      </p>
    </div>
  );
}
