import type { Actions } from "../../state/actions.ts";
import type { AppState } from "../../state/app-state.ts";
import { Loaded } from "../shared/loaded.tsx";
import { EstimatorTable } from "./estimator-table.tsx";
import { FitForm } from "./fit-form.tsx";

/** Forces from recorded signals: what is learnt from, and all that was learnt. */
export function ForcesPage({ state, actions }: { state: AppState; actions: Actions }) {
  return (
    <article>
      <h1>Forces</h1>
      <FitForm draft={state.forcesDraft} actions={actions.forcesDraft} />
      <section class="panel" aria-labelledby="estimators-title">
        <h2 id="estimators-title">Estimators</h2>
        <Loaded of={state.estimators} what="the estimators" onRetry={() => void actions.estimators.reload()}>
          {({ entries, next_cursor }) =>
            entries.length === 0 ? (
              <p class="quiet">Nothing was learnt yet.</p>
            ) : (
              <>
                <EstimatorTable estimators={entries} now_ms={state.now_ms} />
                {next_cursor !== null && (
                  <button type="button" onClick={() => void actions.estimators.loadOlder()}>
                    Show older estimators
                  </button>
                )}
              </>
            )
          }
        </Loaded>
      </section>
    </article>
  );
}
