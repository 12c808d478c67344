import assert from "node:assert/strict";
import { test } from "node:test";
import { borders } from "./cell-borders.ts";

test("cells end half way to their neighbours", () => {
  assert.deepEqual(borders([-10, 0, 10]), [-15, -5, 5, 15]);
  assert.deepEqual(borders([3]), [2.5, 3.5]);
});
