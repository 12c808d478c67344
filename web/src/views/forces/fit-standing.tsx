import { duration } from "../../lib/format.ts";
import type { EstimatorDetail } from "../../wire.ts";
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

/** How far a fit is, or why it has no model. */
export function FitStanding({ estimator, lost, now_ms, actions }: Props) {
  const { state, error, progress, started } = estimator;
  if (state === "failed")
    return <ProblemBox problem={{ title: "Nothing was learnt.", status: 0, detail: error ?? "Nothing was learnt; the service gave no reason." }} />;
  if (isOver(state)) return <p class="notice">Cancelled: nothing was learnt. Submit the recordings again under Forces.</p>;
  const { done, of } = progress ?? { done: 0, of: 0 };
  const total = of > 0 ? of : null;
  return (
    <section class="panel" aria-label="Progress">
      <p role="status">
        {state === "queued" ? "Waiting for its turn." : "Judging models on rows that they didn't learn from, then learning the best from all rows."}
      </p>
      <progress class="wide" max={1} value={share({ done, total })} aria-label="Models judged">
        {done} of {total ?? "?"}
      </progress>
      <p class="quiet">
        {done} of {total ?? "?"} models judged{started != null && `, ${duration((now_ms - Date.parse(started)) / 1000)} at work`}.
        {lost && " The service doesn't answer; asking again every second."}
      </p>
      <div class="actions">
        <button type="button" onClick={() => void actions.cancel()}>
          Cancel
        </button>
      </div>
    </section>
  );
}
