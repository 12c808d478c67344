import { duration } from "../../lib/format.ts";
import type { EstimatorDetail, FitStage } from "../../wire.ts";
import { expectedTime } from "../../lib/study/expected-cost.ts";
import { isOver, share } from "../../lib/study/point-progress.ts";
import type { OpenEstimatorActions } from "../../state/forces/open-estimator.ts";
import { ProblemBox } from "../shared/problem-box.tsx";

interface Props {
  estimator: EstimatorDetail;
  /** The service was asked again and didn't answer. */
  lost: boolean;
  now_ms: number;
  actions: OpenEstimatorActions;
}

const STAGES: Record<FitStage, string> = {
  reading: "Reading the recordings.",
  "start-value": "Trying whether first readings are taken off.",
  judging: "Judging models on rows that they didn't learn from.",
  learning: "Learning the best from all rows.",
};

/** How far a fit is, or why it has no model. */
export function FitStanding({ estimator, lost, now_ms, actions }: Props) {
  const { state, error, progress, started, estimate } = estimator;
  if (state === "failed")
    return <ProblemBox problem={{ title: "Nothing was learnt.", status: 0, detail: error ?? "Nothing was learnt; the service gave no reason." }} />;
  if (isOver(state)) return <p class="notice">Cancelled: nothing was learnt. Submit the recordings again under Forces.</p>;
  const { done, of } = progress ?? { done: 0, of: 0 };
  const total = of > 0 ? of : null;
  return (
    <section class="panel" aria-label="Progress">
      <p role="status">{state === "queued" ? "Waiting for its turn." : STAGES[progress?.stage ?? "reading"]}</p>
      <progress class="wide" max={1} value={share({ done, total })} aria-label="Pieces of work done">
        {done} of {total ?? "?"}
      </progress>
      <p class="quiet">
        {done} of {total ?? "?"} {progress?.stage === "judging" ? "models judged" : "pieces of this stage done"}
        {estimate != null && `, expected to take ${expectedTime(estimate)}`}
        {started != null && `, ${duration((now_ms - Date.parse(started)) / 1000)} at work`}.{lost && " The service doesn't answer; asking again every second."}
      </p>
      <div class="actions">
        <button type="button" onClick={() => void actions.cancel()}>
          Cancel
        </button>
      </div>
    </section>
  );
}
