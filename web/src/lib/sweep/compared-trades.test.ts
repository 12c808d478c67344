import assert from "node:assert/strict";
import { test } from "node:test";
import type { ComparedAnswer, ComparedStudy, TradeRow } from "../../wire.ts";
import { answered, comparedTrades } from "./compared-trades.ts";

function study(id: string, rank: number | null): ComparedStudy {
  const row = (films: number): TradeRow => ({
    film_count: films,
    rank: films,
    index: films,
    words: `${films} films along y`,
    angle_error_deg: 60 / films,
    angle_claim_deg: 1,
    is_front: true,
  });
  const answer: ComparedAnswer | null =
    rank === null
      ? null
      : { rank, layout_rank: 12, words: "12 films along y", film_count: 12, verdict: "tied", angle_deg: { value: 5, error: 1 }, trade: [row(6), row(12)] };
  return { id, name: `wall ${id}`, state: "done", answer };
}

test("studies with a layout come best first, and the layout that is compared is picked", () => {
  const studies = [study("a", 2), study("b", null), study("c", 1)];
  assert.deepEqual(
    answered(studies).map(({ id }) => id),
    ["c", "a"],
  );
  const drawn = comparedTrades(studies);
  assert.deepEqual(
    drawn.map(({ kind, trade }) => [kind, trade.points.map(({ error, is_picked }) => [error, is_picked])]),
    ["place-0", "place-1"].map((place) => [
      `layout-curve ${place}`,
      [
        [10, false],
        [5, true],
      ],
    ]),
  );
});

test("only the best few have a colour", () => {
  const drawn = comparedTrades(Array.from({ length: 8 }, (_, k) => study(String(k), k + 1)));
  assert.deepEqual(
    drawn.map(({ isColoured }) => isColoured),
    [true, true, true, true, true, true, false, false],
  );
});
