import { ACCURACIES, accuracyOf, parseDraft, type Accuracy } from "../../../lib/document/draft-text.ts";
import { bytes, integer } from "../../../lib/format.ts";
import { expectedTime } from "../../../lib/study/expected-cost.ts";
import type { DraftCheck, StudyDraft } from "../../../state/app-state.ts";
import { Facts } from "../../shared/facts.tsx";

interface Props {
  draft: StudyDraft;
  check: DraftCheck;
  onAccuracy: (accuracy: Accuracy) => void;
}

/** The button that runs the draft, beside what that would take. */
export function RunBox({ draft, check, onAccuracy }: Props) {
  return (
    <section class="panel run-box" aria-label="Run">
      <div class="actions">
        <button type="submit" class="primary" disabled={draft.sending || draft.text.trim() === ""}>
          {draft.sending ? "Sending …" : "Run study"}
        </button>
        <AccuracyChoice text={draft.text} onChoose={onAccuracy} />
      </div>
      <div class={check.asking ? "run-cost stale" : "run-cost"} role="status">
        <Cost check={check} />
      </div>
    </section>
  );
}

function Cost({ check }: { check: DraftCheck }) {
  const { estimate, problem, asking } = check;
  if (problem !== null) {
    const faults = problem.errors?.length ?? 0;
    if (faults > 0) return <p class="run-faults">{faults === 1 ? "One fault" : `${faults} faults`} to mend first.</p>;
    return <p class="run-faults">{problem.detail ?? problem.title}</p>;
  }
  if (estimate === null) return <p class="quiet">{asking ? "Checking …" : "Checked and estimated as you type."}</p>;
  const { left, known } = estimate.solves;
  const solves = left.least === left.most ? integer(left.expected) : `${integer(left.least)} to ${integer(left.most)}`;
  return (
    <>
      <Facts
        facts={[
          ["Expected time", expectedTime(estimate)],
          ["Memory", bytes(estimate.peak_memory_bytes)],
          ["Database", `${bytes(estimate.database_bytes)} more`],
          ["Solves", known > 0 ? `${solves}, ${integer(known)} stored` : solves],
        ]}
      />
      {(estimate.unlikely ?? []).map((slip) => (
        <p key={slip} class="run-faults">
          Unlikely value in {slip}
        </p>
      ))}
      {estimate.reasons.length > 0 && (
        <details>
          <summary>How sure the estimate is</summary>
          {estimate.reasons.map((reason) => (
            <p key={reason} class="quiet">
              {reason.charAt(0).toUpperCase() + reason.slice(1)}.
            </p>
          ))}
        </details>
      )}
    </>
  );
}

function AccuracyChoice({ text, onChoose }: { text: string; onChoose: (accuracy: Accuracy) => void }) {
  const isReadable = !("fault" in parseDraft(text));
  const accuracy = accuracyOf(text);
  return (
    <label>
      Accuracy{" "}
      <select value={accuracy ?? ""} disabled={!isReadable} onChange={(event) => onChoose(event.currentTarget.value as Accuracy)}>
        {accuracy === null && (
          <option value="" disabled>
            as written
          </option>
        )}
        {ACCURACIES.map((name) => (
          <option key={name} value={name}>
            {name}
          </option>
        ))}
      </select>
    </label>
  );
}
