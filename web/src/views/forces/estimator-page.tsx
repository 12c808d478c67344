import { estimatorAddress } from "../../api.ts";
import type { EstimatorDetail, ForceReport, LeftOutRows, Report } from "../../wire.ts";
import { noteWords } from "../../lib/forces/force-words.ts";
import { leftOutText } from "../../lib/forces/estimates-text.ts";
import { formatRoute, type EstimatorRoute } from "../../lib/route.ts";
import { fileName } from "../../lib/shell/file-names.ts";
import type { Actions } from "../../state/actions.ts";
import type { AppState, OpenEstimator } from "../../state/app-state.ts";
import { isMissing, type Loadable } from "../../state/loadable.ts";
import { Loaded } from "../shared/loaded.tsx";
import { save } from "../shared/picture/picture-file.ts";
import { ProblemBox } from "../shared/problem-box.tsx";
import { RadioChoice } from "../shared/radio-choice.tsx";
import { StateBadge } from "../shared/state-badge.tsx";
import { Removed } from "../shell/missing.tsx";
import { ApplyPanel } from "./apply-panel.tsx";
import { FitStanding } from "./fit-standing.tsx";
import { ForceAnswers } from "./force-answers.tsx";
import { LeftOutPanel } from "./left-out-panel.tsx";
import { RecordingsTable } from "./recordings-table.tsx";
import { BeginningsPanel } from "./beginnings-panel.tsx";
import { SplitPanel } from "./split-panel.tsx";

interface Props {
  state: AppState;
  route: EstimatorRoute;
  actions: Actions;
}

/** One estimator: how far its fit is, or what was found, and forces by it. */
export function EstimatorPage({ state, route, actions }: Props) {
  const open = state.openEstimator;
  if (open !== null && isMissing(open.detail)) {
    return (
      <Removed what="Estimator" problem={open.detail.problem}>
        <a href={formatRoute({ view: "forces" })}>All estimators</a>,{" "}
      </Removed>
    );
  }
  if (open === null || open.detail.status !== "ready") {
    return (
      <>
        <h1>Estimator</h1>
        <Loaded of={open?.detail ?? { status: "loading" }} what="the estimator" onRetry={actions.openEstimator.reopen}>
          {() => null}
        </Loaded>
      </>
    );
  }
  return (
    <Loaded of={open.detail} what="the estimator" onRetry={actions.openEstimator.reopen}>
      {(estimator) => (
        <article>
          <header class="study-head">
            <h1>{estimator.name}</h1>
            <StateBadge state={estimator.state} />
          </header>
          {open.problem !== null && <ProblemBox problem={open.problem} />}
          {estimator.state === "done" ? (
            <Found estimator={estimator} open={open} route={route} actions={actions} />
          ) : (
            <FitStanding estimator={estimator} lost={open.lost} now_ms={state.now_ms} actions={actions.openEstimator} />
          )}
          <RecordingsTable recordings={estimator.recordings} />
          <div class="actions estimator-end">
            <button type="button" onClick={() => isSure(estimator) && void actions.openEstimator.remove()}>
              Remove estimator
            </button>
            <p class="quiet">
              <a href={formatRoute({ view: "forces" })}>All estimators</a>
            </p>
          </div>
        </article>
      )}
    </Loaded>
  );
}

const isSure = ({ name }: EstimatorDetail): boolean => window.confirm(`Remove “${name}” with its recordings? Nothing brings them back.`);

function Found({ estimator, open, route, actions }: { estimator: EstimatorDetail; open: OpenEstimator; route: EstimatorRoute; actions: Actions }) {
  return (
    <Loaded of={open.report ?? { status: "loading" }} what="the report" onRetry={actions.openEstimator.reopen}>
      {(report) => (
        <>
          <Files estimator={estimator} leftOut={open.leftOut} />
          <ForceAnswers report={report} />
          <OneForce estimator={estimator} report={report} open={open} route={route} actions={actions} />
          <Notes report={report} />
          <ApplyPanel id={estimator.id} name={estimator.name} />
        </>
      )}
    </Loaded>
  );
}

/** Table and plot of the force that is chosen. */
function OneForce(props: { estimator: EstimatorDetail; report: Report; open: OpenEstimator; route: EstimatorRoute; actions: Actions }) {
  const { estimator, report, open, route, actions } = props;
  const force = report.forces.find(({ force }) => force === route.force) ?? report.forces[0];
  if (force === undefined) return null;
  const choice = <ForceChoice forces={report.forces} chosen={force} onChoose={(chosen) => actions.adjust({ ...route, force: chosen })} />;
  return (
    <>
      <SplitPanel force={force} choice={choice} />
      <BeginningsPanel force={force} />
      <Loaded of={open.leftOut ?? { status: "loading" }} what="the rows that were left out" onRetry={actions.openEstimator.reopen}>
        {(forces) => {
          const rows = forces.find((left) => left.force === force.force);
          return rows === undefined ? null : <LeftOutPanel name={estimator.name} rows={rows} by={force.models[0]?.validation.by} files={filesOf(estimator)} />;
        }}
      </Loaded>
    </>
  );
}

const filesOf = ({ recordings }: EstimatorDetail): string[] => recordings.map(({ file }) => file);

function ForceChoice({ forces, chosen, onChoose }: { forces: readonly ForceReport[]; chosen: ForceReport; onChoose: (force: string) => void }) {
  if (forces.length < 2) return null;
  return (
    <RadioChoice name="force" legend="Force" options={forces.map(({ force }) => ({ value: force, label: force }))} chosen={chosen.force} onChoose={onChoose} />
  );
}

function Notes({ report }: { report: Report }) {
  if (report.notes.length === 0) return null;
  const forces = report.forces.map(({ force }) => force);
  return (
    <section class="panel" aria-labelledby="notes-title">
      <h2 id="notes-title">Notes</h2>
      <ul class="fit-notes">
        {report.notes.map((note) => (
          <li key={note}>{noteWords(note, forces)}</li>
        ))}
      </ul>
    </section>
  );
}

/** What can be taken away: the model for the command line, the report, and the rows that were left out. */
function Files({ estimator, leftOut }: { estimator: EstimatorDetail; leftOut: Loadable<LeftOutRows[]> | null }) {
  const { id, name } = estimator;
  const saveLeftOut = (forces: readonly LeftOutRows[]): void =>
    save(new Blob([leftOutText(forces, filesOf(estimator))], { type: "text/csv" }), fileName(name, "left out", "csv"));
  return (
    <p class="provenance">
      as JSON:{" "}
      <a href={estimatorAddress(id, "/model")} download={fileName(name, "model", "json")}>
        the model
      </a>
      , for <code>strainsite force apply</code>; <a href={estimatorAddress(id, "/report")}>the report</a>;{" "}
      <a href={estimatorAddress(id, "/left-out")}>rows that were left out</a>
      {leftOut?.status === "ready" && (
        <>
          , these as{" "}
          <button type="button" class="link" aria-label="Save rows that were left out as CSV" onClick={() => saveLeftOut(leftOut.value)}>
            CSV
          </button>
        </>
      )}
    </p>
  );
}
