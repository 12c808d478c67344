import assert from "node:assert/strict";
import { test } from "node:test";
import { previewRows, roundPeak } from "./preview-rows.ts";
import type { Preview } from "../../../wire.ts";

const preview = (...locations: [string, number, number | null][]): Preview =>
  ({
    locations: locations.map(([name, rank, x]) => ({ name, rank, gsi_x_percent: x, gsi_y_percent: 1, rank_certain: false })),
  }) as unknown as Preview;

test("places keep their order and say what they were at the start", () => {
  const rows = previewRows(preview(["P10", 1, 60], ["P2", 2, null]), preview(["P2", 1, 70], ["P10", 2, 30]));
  assert.deepEqual(
    rows.map(({ name }) => name),
    ["P2", "P10"],
  );
  assert.deepEqual(rows[1], { name: "P10", rank: 1, x: 60, y: 1, x_before: 30, y_before: 1, gained: 1 });
  assert.equal(rows[0]?.gained, -1);
  assert.equal(rows[0]?.x, null);
  assert.equal(previewRows(preview(["P1", 1, 5]), null)[0]?.x_before, null);
});

test("a scale ends at a round number", () => {
  assert.deepEqual(
    [0.087, 0.1, 0.11, 4, 0].map(roundPeak).map((peak) => Number(peak.toPrecision(6))),
    [0.1, 0.1, 0.15, 5, 1],
  );
});
