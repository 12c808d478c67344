import { useRef } from "preact/hooks";
import { designCount, locateInGrid, readGrid } from "../../lib/sweep/design-grid.ts";
import { bytes, integer } from "../../lib/format.ts";
import { expectedTime } from "../../lib/study/expected-cost.ts";
import type { Actions } from "../../state/actions.ts";
import type { SweepDraft } from "../../state/app-state.ts";
import type { SweepEstimate } from "../../wire.ts";
import { Facts } from "../shared/facts.tsx";
import { Faults, selectIn, type Place } from "./fault-list.tsx";

const IDLE = "Every combination is a design: two lines of three values are nine. The sweep is checked and estimated before it can be run.";
const STUDY = "/study";

interface Props {
  draft: SweepDraft;
  /** The study as it is written. */
  text: string;
  placeInStudy: (pointer: string) => Place | null;
  actions: Actions;
}

/** Writes a sweep of the study above: what it varies, what it would take, what is wrong with it. */
export function SweepForm({ draft, text, placeInStudy, actions }: Props) {
  const area = useRef<HTMLTextAreaElement>(null);
  const placeOf = (pointer: string): Place | null => {
    if (pointer.startsWith(STUDY)) return placeInStudy(pointer.slice(STUDY.length));
    const span = locateInGrid(draft.grid, pointer);
    return span === null ? null : { span, show: () => selectIn(area.current, span) };
  };
  const submit = (event: Event): void => {
    event.preventDefault();
    void actions.sweepDraft.estimate();
  };
  return (
    <section class="panel" aria-labelledby="sweep-title">
      <h2 id="sweep-title">The same for many designs: a sweep</h2>
      <form class="new-sweep" onSubmit={submit}>
        <div class="document">
          <div class="document-text">
            <label for="sweep-name">Name, the study's when empty</label>
            <input
              id="sweep-name"
              class="line"
              autocomplete="off"
              value={draft.name}
              onInput={(event) => actions.sweepDraft.edit({ name: event.currentTarget.value })}
            />
            <label for="grid">What varies, a path and its values in each line</label>
            <textarea
              id="grid"
              ref={area}
              spellcheck={false}
              autocomplete="off"
              rows={5}
              placeholder={"geometry.wall_mm = 2.5, 3, 3.5\ncarcass.angle_deg = 50, 55, 60"}
              value={draft.grid}
              aria-describedby="sweep-faults"
              aria-invalid={draft.problem !== null}
              onInput={(event) => actions.sweepDraft.edit({ grid: event.currentTarget.value })}
            />
          </div>
          <div id="sweep-faults" class="faults" aria-live="polite">
            <Faults problem={draft.problem} placeOf={placeOf} idle={IDLE} />
          </div>
        </div>
        <SweepSteps draft={draft} text={text} actions={actions} />
      </form>
    </section>
  );
}

function SweepSteps({ draft, text, actions }: { draft: SweepDraft; text: string; actions: Actions }) {
  const { estimated, busy } = draft;
  if (estimated !== null && estimated.text === text) {
    return (
      <>
        <Estimated estimate={estimated.estimate} />
        <div class="actions">
          <EngineChoice engines={estimated.engines} chosen={draft.engine} onChoice={actions.sweepDraft.choose} />
          <button type="button" class="primary" disabled={busy !== null} onClick={() => void actions.sweepDraft.submit()}>
            {busy === "sending" ? "Sending …" : `Run ${estimated.estimate.designs.length} designs`}
          </button>
        </div>
      </>
    );
  }
  const count = designCount(readGrid(draft.grid));
  return (
    <div class="actions">
      <button type="submit" disabled={busy !== null || text.trim() === ""}>
        {busy === "estimating" ? "Estimating …" : "Check and estimate"}
      </button>
      {count > 0 && <p class="quiet">{count === 1 ? "1 design" : `${integer(count)} designs`}</p>}
    </div>
  );
}

interface ChoiceProps {
  engines: string[];
  chosen: string | null;
  onChoice: (engine: string | null) => void;
}

/** Whose machines solve the designs, where there are others than the service's. */
function EngineChoice({ engines, chosen, onChoice }: ChoiceProps) {
  if (engines.length === 0) return null;
  return (
    <label>
      solved by{" "}
      <select value={chosen ?? ""} onChange={(event) => onChoice(event.currentTarget.value === "" ? null : event.currentTarget.value)}>
        <option value="">this service</option>
        {engines.map((engine) => (
          <option key={engine} value={engine}>
            machines of {engine}
          </option>
        ))}
      </select>
    </label>
  );
}

function Estimated({ estimate }: { estimate: SweepEstimate }) {
  const { left, designs } = estimate;
  const solves = left.least === left.most ? integer(left.expected) : `${integer(left.expected)} (${integer(left.least)} to ${integer(left.most)})`;
  const facts: [string, string][] = [
    ["Designs", integer(designs.length)],
    ["Solves left", solves],
    ["Time, one design after the other", expectedTime(estimate)],
    ["Peak memory", bytes(estimate.peak_memory_bytes)],
    ["Database", `${bytes(estimate.database_bytes)} more`],
  ];
  const unlikely = new Set(designs.flatMap((design) => design.estimate.unlikely ?? []));
  const reasons = new Set(designs.flatMap((design) => design.estimate.reasons));
  return (
    <div role="status">
      <Facts facts={facts} />
      {[...unlikely].map((slip) => (
        <p key={slip} class="run-faults">
          Unlikely value in {slip}
        </p>
      ))}
      {[...reasons].map((reason) => (
        <p key={reason} class="quiet">
          {reason}
        </p>
      ))}
    </div>
  );
}
