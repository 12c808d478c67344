import assert from "node:assert/strict";
import { test } from "node:test";
import { closedPath, linePath } from "./paths.ts";

test("a path goes through its points, without digits that can't be seen", () => {
  const points = [[0, 0] as const, [10.04, -2.06] as const];
  assert.equal(linePath(points), "M0 0L10 -2.1");
  assert.equal(closedPath(points), "M0 0L10 -2.1Z");
  assert.deepEqual([linePath([]), closedPath([])], ["", ""]);
});
