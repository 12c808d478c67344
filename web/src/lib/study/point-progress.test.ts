import assert from "node:assert/strict";
import { test } from "node:test";
import type { StudySummary } from "../../wire.ts";
import { advance, elapsedSeconds, fromSummary, newtonIterations, secondsLeft, share, withSummary, type Progress } from "./point-progress.ts";
import type { StudyEvent } from "./stream-events.ts";

const queued: StudySummary = {
  id: "1",
  name: "n",
  state: "queued",
  spec_sha256: "b",
  priority: 0,
  points_total: null,
  points_done: 0,
  created: "2026-01-01T00:00:00Z",
  started: null,
  finished: null,
  error: null,
};
const solved = (ordinal: number, done: number): StudyEvent => ({
  kind: "point-solved",
  ordinal,
  done,
  of: 31,
  wall_s: 2,
  newton_iterations: 9,
});
const after = (events: StudyEvent[], now = 10_000): Progress => events.reduce((progress, event) => advance(progress, event, now), fromSummary(queued));

test("a study starts, solves points and is done", () => {
  const running = after([{ kind: "queued" }, { kind: "started", points: 31, reused: 1 }, solved(1, 2), solved(2, 3)]);
  assert.equal(running.state, "running");
  assert.equal(running.done, 3);
  assert.equal(newtonIterations(running), 18);
  assert.equal(share(running), 3 / 31);
  assert.equal(advance(running, { kind: "done" }, 12_000).state, "done");
});

test("an event told twice counts once and a late one doesn't turn the count back", () => {
  const running = after([solved(1, 2), solved(2, 3), solved(1, 2)]);
  assert.equal(running.done, 3);
  assert.equal(newtonIterations(running), 18);
});

test("nothing moves a study that is over", () => {
  const cancelled = after([solved(1, 2), { kind: "cancelled" }]);
  assert.deepEqual(advance(cancelled, solved(2, 3), 20_000), cancelled);
  assert.equal(withSummary(cancelled, { ...queued, state: "running" }).state, "cancelled");
});

test("time left is the pace of solved points, not of reused ones", () => {
  const running = after([{ kind: "started", points: 31, reused: 11 }, solved(11, 12), solved(12, 13)], 0);
  assert.equal(elapsedSeconds(running, 4_000), 4);
  // Two points in four seconds, eighteen to go.
  assert.equal(secondsLeft(running, 4_000), 36);
  assert.equal(secondsLeft(fromSummary(queued), 4_000), null);
});

test("a point without an equilibrium is done, and its study goes on", () => {
  const failed: StudyEvent = { kind: "point-failed", ordinal: 2, done: 3, of: 31, cause: "crushed" };
  const running = after([solved(1, 2), failed, solved(3, 4)]);
  assert.deepEqual([running.state, running.done, running.failures.length], ["running", 4, 1]);
  assert.equal(after([solved(1, 2), failed]).done, 3);
});

test("a plan that isn't known yet has no share and no end, and is never forgotten", () => {
  const waiting = fromSummary(queued);
  assert.deepEqual([waiting.total, share(waiting)], [null, 0]);
  const solving = { ...waiting, state: "running" as const, done: 2, started_ms: 0 };
  assert.equal(secondsLeft(solving, 4_000), null);
  const planned = withSummary(solving, { ...queued, state: "running", points_total: 31, points_done: 2 });
  assert.equal(planned.total, 31);
  assert.equal(withSummary(planned, queued).total, 31);
});

test("failed points are kept in order with their causes", () => {
  const progress = after([
    { kind: "point-failed", ordinal: 9, done: 3, of: 31, cause: "limit point" },
    { kind: "point-failed", ordinal: 4, done: 4, of: 31, cause: "no convergence" },
    { kind: "failed", error: "two points have no response" },
  ]);
  assert.deepEqual(
    progress.failures.map((failure) => failure.ordinal),
    [4, 9],
  );
  assert.equal(progress.error, "two points have no response");
});

test("a polled entry moves the count on but never back", () => {
  const running = after([solved(1, 5)]);
  assert.equal(withSummary(running, { ...queued, state: "running", points_done: 3 }).done, 5);
  assert.equal(withSummary(running, { ...queued, state: "running", points_done: 8 }).done, 8);
});

test("a failed study still takes its failed points from a replayed stream", () => {
  const failed = fromSummary({ ...queued, state: "failed", error: "point 4 has no answer" });
  const told = advance(failed, { kind: "point-failed", ordinal: 4, done: 3, of: 31, cause: "limit point" }, 0);
  assert.deepEqual(told.failures, [{ ordinal: 4, cause: "limit point", values: [] }]);
  const points = [{ ordinal: 4, cause: "limit point", values: [1, 2] }];
  const ended = advance(told, { kind: "failed", error: "again", failed_points: points }, 0);
  assert.deepEqual(ended.failures, points);
  assert.deepEqual([ended.state, ended.error], ["failed", "point 4 has no answer"]);
});

test("after the last point the indices are computed", () => {
  assert.equal(after([solved(30, 31), { kind: "analysing" }]).analysing, true);
});
