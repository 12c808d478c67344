import assert from "node:assert/strict";
import { test } from "node:test";
import type { Estimate, StudySummary } from "../../../wire.ts";
import { countDots, dotBlocks } from "./point-grid.ts";
import { advance, fromSummary, type Progress } from "../point-progress.ts";

const uniform = { kind: "uniform", min: 0, max: 2 };
const DOCUMENT = {
  inputs: [
    { name: "P1", vary: "a", distribution: uniform },
    { name: "P2", vary: "b", distribution: uniform },
  ],
  method: { kind: "mdrm", nodes: 5, check_points: 3 },
  accuracy: { preset: "standard" },
};
const estimate = (own: number, coarser = own): Estimate => ({ solves: { own, coarser } }) as unknown as Estimate;
const summary = { state: "running", points_total: null, points_done: 0 } as unknown as StudySummary;
const solved = (...ordinals: number[]): Progress =>
  ordinals.reduce(
    (progress, ordinal) => advance(progress, { kind: "point-solved", ordinal, done: 1, of: 24, wall_s: 1, newton_iterations: 3 }, 0),
    fromSummary(summary),
  );

test("each input has a line of its nodes about the point at the means, on both meshes", () => {
  const blocks = dotBlocks(DOCUMENT, estimate(12), solved(0, 1, 6, 13));
  assert.deepEqual(
    blocks?.map(({ title }) => title),
    ["The standard mesh", "A coarser mesh, for the mesh's error"],
  );
  const [own, coarser] = blocks ?? [];
  assert.equal(own?.cut, "solved");
  assert.deepEqual(own?.rows, [
    { name: "P1", dots: ["solved", "open", "open", "open"], cut: 2 },
    { name: "P2", dots: ["open", "solved", "open", "open"], cut: 2 },
    { name: "checks", dots: ["open", "open", "open"], cut: null },
  ]);
  assert.equal(coarser?.cut, "open");
  assert.equal(coarser?.rows[0]?.dots[0], "solved");
  assert.equal(countDots(blocks ?? [], "solved"), 4);
});

test("failed points are told apart, and all are solved when the study is done", () => {
  const failed = advance(solved(0), { kind: "point-failed", ordinal: 2, done: 1, of: 31, cause: "buckles" }, 0);
  assert.equal(dotBlocks(DOCUMENT, estimate(12), failed)?.[0]?.rows[0]?.dots[1], "failed");
  const done = advance(solved(0), { kind: "done" }, 0);
  assert.equal(countDots(dotBlocks(DOCUMENT, estimate(12), done) ?? [], "open"), 0);
});

test("plans without lines, of unequal lines or of too many points have no picture", () => {
  const progress = solved(0);
  assert.equal(dotBlocks(DOCUMENT, null, progress), null);
  assert.equal(dotBlocks(DOCUMENT, estimate(13), progress), null, "one of two lines has a node more");
  assert.equal(dotBlocks({ ...DOCUMENT, method: { kind: "pce" } }, estimate(200), progress), null);
  assert.equal(dotBlocks({ ...DOCUMENT, accuracy: { tolerance: 0.1 } }, estimate(12), progress), null);
  assert.equal(dotBlocks(DOCUMENT, estimate(4004), progress), null);
  assert.equal(dotBlocks(DOCUMENT, estimate(12, 0), progress)?.length, 1, "the coarsest mesh has none below");
});
