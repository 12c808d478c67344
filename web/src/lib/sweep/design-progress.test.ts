import assert from "node:assert/strict";
import { test } from "node:test";
import type { DesignView, StudySummary, SweepDetail } from "../../wire.ts";
import {
  countsText,
  tasksText,
  designsOf,
  designsOver,
  designsToResume,
  nameSaysAll,
  settingsText,
  sweepSecondsLeft,
  sweepShare,
  variedPaths,
} from "./design-progress.ts";

const second = (seconds: number): string => new Date(1000 * seconds).toISOString();

function design(ordinal: number, study: Partial<StudySummary>, change: Partial<DesignView> = {}): DesignView {
  const summary: StudySummary = {
    id: `s${ordinal}`,
    name: "n",
    state: "queued",
    spec_sha256: "b",
    priority: 0,
    points_total: null,
    points_done: 0,
    created: second(0),
    started: null,
    finished: null,
    error: null,
    ...study,
  };
  return { ordinal, name: `wall_mm = ${ordinal}`, set: { "geometry.wall_mm": ordinal }, study: summary, ...change };
}

function sweep(designs: DesignView[], state: SweepDetail["state"] = "running"): SweepDetail {
  const counts = { queued: 0, running: 0, done: 0, failed: 0, cancelled: 0 };
  for (const { study } of designs) counts[study.state] += 1;
  return {
    id: "w",
    name: "walls",
    state,
    counts,
    priority: 0,
    points_total: null,
    points_done: 0,
    created: second(0),
    finished: null,
    worked_s: 0,
    document: {},
    designs,
  };
}

const done = (ordinal: number, from: number, to: number): DesignView =>
  design(ordinal, { state: "done", points_total: 26, points_done: 26, started: second(from), finished: second(to) });

test("designs are counted by state", () => {
  const some = sweep([done(1, 0, 8), design(2, { state: "failed" }), design(3, { state: "running" }), design(4, {})]);
  assert.equal(countsText(some), "1 queued, 1 running, 1 done, 1 failed");
  assert.deepEqual([designsOf(some), designsOver(some), designsToResume(some)], [4, 2, 1]);
});

test("the share goes by designs, for the plan of one is known when it starts", () => {
  const half = design(2, { state: "running", points_total: 26, points_done: 13, started: second(8) });
  assert.equal(sweepShare(sweep([done(1, 0, 8), half, design(3, {}), design(4, {})])), 0.375);
  assert.equal(sweepShare(sweep([])), 0);
});

test("the time left goes by the time at work, and by designs that aren't in view, too", () => {
  const half = design(3, { state: "running", points_total: 26, points_done: 13, started: second(100) });
  // 16 s for two and a half designs.
  const some = { ...sweep([done(1, 0, 8), done(2, 6, 12), half, design(4, {})]), worked_s: 16 };
  assert.equal(sweepSecondsLeft(some)?.toFixed(6), "9.600000");
  assert.equal(sweepSecondsLeft({ ...some, designs: [half] })?.toFixed(6), "9.600000");
  assert.equal(sweepSecondsLeft(sweep([design(1, {})], "queued")), null);
  assert.equal(sweepSecondsLeft(sweep([done(1, 0, 8)], "done")), null);
});

test("what is varied is told path by path", () => {
  const named = design(2, {}, { name: "thick", set: { "geometry.wall_mm": 4, "material.model": "yeoh", "ground.depths_mm": [1, 2] } });
  assert.deepEqual(variedPaths([design(1, {}), design(1, {}), named]), [
    { path: "geometry.wall_mm", values: ["1", "4"] },
    { path: "material.model", values: ["yeoh"] },
    { path: "ground.depths_mm", values: ["[1,2]"] },
  ]);
  assert.equal(settingsText(named.set), "geometry.wall_mm = 4, material.model = yeoh, ground.depths_mm = [1,2]");
  assert.ok(nameSaysAll(design(1, {})));
  assert.ok(!nameSaysAll(named));
  assert.ok(nameSaysAll(design(1, {}, { name: "unchanged", set: {} })));
});

test("tasks elsewhere are told by where they stand, with the reason why they wait", () => {
  const tasks = { waiting: 3, running: 2, ended: 5 };
  assert.equal(tasksText({ tasks, because: "Resources" }), "3 waiting (Resources), 2 running, 5 ended");
  assert.equal(tasksText({ tasks: { waiting: 0, running: 0, ended: 4 }, because: null }), "4 ended");
  assert.equal(tasksText({ tasks: { waiting: 0, running: 0, ended: 0 }, because: null }), "being made");
});
