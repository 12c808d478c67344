import assert from "node:assert/strict";
import { test } from "node:test";

import type { TradeAnswer, TradeRow } from "../../wire.ts";
import { errorsOf, filmTrade } from "./film-trade.ts";

const row = (film_count: number, angle: number, claim: number | null, force: number | null): TradeRow => ({
  film_count,
  rank: 1,
  index: 0,
  words: `${film_count} films along y`,
  angle_error_deg: angle,
  angle_claim_deg: claim,
  force_error_n: force,
  force_claim_n: null,
  meets: null,
  is_front: true,
});

const trade = (question: TradeAnswer["question"]): TradeAnswer => ({
  question,
  rows: [row(6, 141, 13, null), row(12, 10.65, 1.8, 1.69), row(24, 1.92, null, 0.5)],
  picked: 1,
  knee: 2,
  tried: 3,
  screened: 0,
  without_room: 0,
  menu: "3 layouts were tried.",
});

test("the angle's error is drawn with its claim, and the picked layout is marked", () => {
  const drawn = filmTrade(trade({ films: 12 }));
  assert.deepEqual(
    drawn.points.map(({ error, is_picked }) => [error, is_picked]),
    [
      [141, false],
      [10.65, true],
      [1.92, false],
    ],
  );
  assert.equal(drawn.points[1]?.title, "12 films along y: 10.7 ± 1.8°");
  assert.deepEqual([drawn.films, drawn.limit], [12, null]);
  const [low, high] = errorsOf(drawn);
  assert.ok(low < 1.92 && high > 154);
});

test("where only the force has a limit its error is drawn; rows without one are left out", () => {
  const drawn = filmTrade(trade({ force_n: 2 }));
  assert.deepEqual(
    drawn.points.map(({ error }) => error),
    [1.69, 0.5],
  );
  assert.deepEqual([drawn.limit, drawn.unit], [2, " N"]);
  assert.equal(filmTrade(trade({ force_n: 2, angle_deg: 5 })).limit, 5);
});
