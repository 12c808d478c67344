import { duration, fixed, integer, moment, significant } from "../../../lib/format.ts";
import { dotBlocks } from "../../../lib/study/progress/point-grid.ts";
import { elapsedSeconds, isOver, newtonIterations, secondsLeft, share, type PointFailure, type Progress } from "../../../lib/study/point-progress.ts";
import type { Link, OpenStudy } from "../../../state/app-state.ts";
import type { Estimate } from "../../../wire.ts";
import { Facts } from "../../shared/facts.tsx";
import { ProblemBox } from "../../shared/problem-box.tsx";
import { CurrentSolves } from "./current-solves.tsx";
import { PointDots } from "./point-dots.tsx";

interface Props {
  open: OpenStudy;
  progress: Progress;
  now_ms: number;
  onCancel: () => void;
}

/** How far a study is, or where it ended. */
export function StudyProgress({ open, progress, now_ms, onCancel }: Props) {
  const over = isOver(progress.state);
  const detail = open.detail.status === "ready" ? open.detail.value : null;
  const blocks = detail === null ? null : dotBlocks(detail.document, detail.estimate, progress);
  // Nobody knows what happens while the service doesn't answer: the clock stands where it was heard last.
  const clock_ms = over ? now_ms : (open.lost_ms ?? now_ms);
  return (
    <section class="panel" aria-label="Progress">
      <Outcome progress={progress} />
      {!over && open.lost_ms !== null && <Lost lost_ms={open.lost_ms} now_ms={now_ms} />}
      <progress class="wide" max={1} value={share(progress)} aria-label="Points solved">
        {progress.done} of {progress.total ?? "?"}
      </progress>
      <Standing progress={progress} now_ms={clock_ms} estimate={detail?.estimate ?? null} />
      {progress.state === "running" && open.lost_ms === null && <CurrentSolves solves={progress.solves} />}
      {blocks !== null && <PointDots blocks={blocks} />}
      <Failures failures={progress.failures} />
      {open.problem !== null && <ProblemBox problem={open.problem} />}
      {!over && (
        <div class="actions">
          <button type="button" onClick={onCancel}>
            Cancel study
          </button>
          <p class="quiet">
            Points solved so far stay stored. <LinkText link={open.link} />
          </p>
        </div>
      )}
    </section>
  );
}

function Outcome({ progress }: { progress: Progress }) {
  switch (progress.state) {
    case "queued":
      return <p role="status">Waiting for a free solver.</p>;
    case "running":
      return <p role="status">{progress.analysing ? "Computing the indices." : "Solving the design points."}</p>;
    case "cancelled":
      return <p role="status">Cancelled. Run the same document again and it goes on from the points solved here.</p>;
    case "done":
      return <p role="status">Done.</p>;
    case "failed":
      return (
        <div class="problem" role="alert">
          <p>{progress.error ?? "The study failed, and no reason was given."}</p>
        </div>
      );
  }
}

function Lost({ lost_ms, now_ms }: { lost_ms: number; now_ms: number }) {
  return (
    <p class="notice" role="status">
      The service hasn't answered since {moment(new Date(lost_ms).toISOString(), new Date(now_ms))}, so the clock stands. What was solved is stored; this page
      asks again every two seconds and goes on by itself.
    </p>
  );
}

function Standing({ progress, now_ms, estimate }: { progress: Progress; now_ms: number; estimate: Estimate | null }) {
  const solved = progress.newton.size;
  const iterations = newtonIterations(progress);
  const facts: [string, string][] = [["Points", `${integer(progress.done)} of ${progress.total === null ? "?" : integer(progress.total)}`]];
  if (progress.reused !== null) facts.push(["Reused", integer(progress.reused)]);
  facts.push(["Elapsed", duration(elapsedSeconds(progress, now_ms))]);
  if (progress.state === "running") facts.push(["Time left", timeLeft(progress, now_ms, estimate)]);
  if (solved > 0) facts.push(["Newton iterations", `${integer(iterations)}, ${fixed(iterations / solved, 1)} a point`]);
  return <Facts facts={facts} />;
}

/** The point at the means takes several times as long as those that start from it, so that a pace is one from a few points on. */
const PACE_POINTS = 4;

/** Measured once points were solved; what was expected of the whole until then. */
function timeLeft(progress: Progress, now_ms: number, estimate: Estimate | null): string {
  const left = secondsLeft(progress, now_ms);
  if (left !== null && progress.newton.size >= PACE_POINTS) return duration(left);
  return estimate?.wall_s == null ? "not known yet" : `about ${duration(estimate.wall_s.expected)} in all`;
}

function Failures({ failures }: { failures: readonly PointFailure[] }) {
  if (failures.length === 0) return null;
  return (
    <div class="problem">
      <p>Points without an answer:</p>
      <ul>
        {failures.map((failure) => (
          <li key={failure.ordinal}>
            point {failure.ordinal}
            {failure.values.length > 0 && ` at (${failure.values.map((value) => significant(value, 4)).join(", ")})`}: {failure.cause}
          </li>
        ))}
      </ul>
    </div>
  );
}

function LinkText({ link }: { link: Link }) {
  switch (link) {
    case "live":
      return <>Following live.</>;
    case "polling":
      return <>The live connection broke; asking every two seconds instead.</>;
    default:
      return null;
  }
}
