import assert from "node:assert/strict";
import { test } from "node:test";
import { bandPaths, bandRuns, forceRange, stretches, thinned, timeRange, type BandRow } from "./band-drawing.ts";

const row = (time_s: number, truth_n: number | null): BandRow => ({ time_s, truth_n, estimate_n: 1, low_n: 0, high_n: 2 });

test("rows are put in order by recording and time, under the names of the files", () => {
  const left = { force: "fz_n", run: [1, 0, 1], time_s: [2, 0, 1], truth_n: [5, 3, 4], estimate_n: [5, 3, 4], low_n: [4, 2, 3], high_n: [6, 4, 5] };
  const runs = bandRuns(left, ["monday.csv"]);
  assert.deepEqual(
    runs.map(({ name, rows }) => [name, rows.map((each) => each.truth_n)]),
    [
      ["monday.csv", [3]],
      ["recording 2", [4, 5]],
    ],
  );
  // Nothing to 6 N, and a twentieth of that on both sides.
  assert.deepEqual(
    forceRange(runs).map((force) => force.toFixed(2)),
    ["-0.30", "6.30"],
  );
  assert.deepEqual(timeRange(runs[1]?.rows ?? []), [1, 2]);
});

test("a thinned run keeps its peaks and its order", () => {
  const rows = Array.from({ length: 1000 }, (_, k) => row(k, k === 777 ? 40 : Math.sin(k)));
  const kept = thinned(rows, 100);
  assert.ok(kept.length <= 100 && kept.length > 50, `${kept.length} rows`);
  assert.ok(kept.some(({ truth_n }) => truth_n === 40));
  assert.deepEqual(
    kept,
    [...kept].sort((a, b) => a.time_s - b.time_s),
  );
  assert.equal(thinned(rows, 1000), rows);
});

test("no line is drawn over a pause, nor where nothing was measured", () => {
  const rows = [0, 1, 2, 3, 50, 51, 52].map((time_s) => row(time_s, time_s));
  assert.deepEqual(
    stretches(rows).map((part) => part.length),
    [4, 3],
  );
  const { band, truth, estimate } = bandPaths(
    rows,
    (value) => value,
    (value) => value,
  );
  assert.equal(truth, "M0 0L1 1L2 2L3 3M50 50L51 51L52 52");
  assert.equal(estimate.split("M").length, 3);
  assert.ok(band.startsWith("M0 2L1 2L2 2L3 2L3 0L2 0L1 0L0 0ZM50 2"));
  assert.equal(
    bandPaths(
      [row(0, null), row(1, null)],
      (value) => value,
      (value) => value,
    ).truth,
    "",
  );
});

test("nothing at all has ranges that can be drawn", () => {
  assert.deepEqual(forceRange([]), [-1, 1]);
  assert.deepEqual(timeRange([]), [0, 1]);
});
