import assert from "node:assert/strict";
import { test } from "node:test";
import type { RankedLayout } from "../../wire.ts";
import { layoutRanks } from "./layout-ranks.ts";

function layout(spacing_deg: number, rank: number, rank_certain: boolean): RankedLayout {
  return { rank, rank_certain, spacing_deg, units: 360 / spacing_deg, position: "crown", films: ["x"], film_count: 1, score: {} } as RankedLayout;
}

test("only ranks that both studies are certain of have changed", () => {
  const base = [layout(30, 1, true), layout(60, 2, true), layout(90, 3, false)];
  const other = [layout(60, 1, true), layout(30, 2, true), layout(90, 2, true)];
  const rows = layoutRanks([base, other], 0, 9);
  assert.deepEqual(
    rows.map(({ layout: name }) => name.match(/every (\d+)/)?.[1]),
    ["30", "60", "90"],
  );
  assert.deepEqual(
    rows.map(({ ranks }) => ranks[1]?.change),
    [1, -1, null],
  );
  assert.deepEqual(
    rows.map(({ ranks }) => ranks[1]?.words),
    ["2=", "1", "2="],
  );
  assert.deepEqual(
    rows.map(({ ranks }) => ranks[0]?.change),
    [null, null, null],
    "the baseline hasn't changed",
  );
});

test("a layout that the baseline hasn't comes last, one that a study hasn't is missing there", () => {
  const rows = layoutRanks([[layout(45, 1, true)], [layout(30, 1, true), layout(45, 7, true)]], 0, 5);
  assert.deepEqual(
    rows.map(({ ranks }) => ranks.map((each) => each?.rank ?? null)),
    [
      [1, 7],
      [null, 1],
    ],
  );
  assert.equal(rows[1]?.ranks[1]?.change, null);
  assert.deepEqual(layoutRanks([[], []], 0, 5), []);
});
