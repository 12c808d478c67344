import assert from "node:assert/strict";
import { test } from "node:test";
import { movedTo } from "./roving.ts";

test("a lone row goes round, and up and down mean nothing in it", () => {
  assert.deepEqual(movedTo({ row: 0, at: 5 }, [6], "ArrowRight"), { row: 0, at: 0 });
  assert.deepEqual(movedTo({ row: 0, at: 0 }, [6], "ArrowLeft"), { row: 0, at: 5 });
  assert.deepEqual(movedTo({ row: 0, at: 2 }, [6], "End"), { row: 0, at: 5 });
  assert.equal(movedTo({ row: 0, at: 2 }, [6], "ArrowDown"), null);
  assert.equal(movedTo({ row: 0, at: 2 }, [6], "x"), null);
});

test("rows keep the place, or the last of a shorter one, and end at their edges", () => {
  const rows = [3, 1, 3];
  assert.deepEqual(movedTo({ row: 0, at: 2 }, rows, "ArrowDown"), { row: 1, at: 0 });
  assert.deepEqual(movedTo({ row: 1, at: 0 }, rows, "End"), { row: 2, at: 0 });
  assert.equal(movedTo({ row: 0, at: 0 }, rows, "ArrowUp"), null);
  assert.equal(movedTo({ row: 0, at: 0 }, rows, "ArrowLeft"), null);
  assert.equal(movedTo({ row: 2, at: 2 }, rows, "ArrowRight"), null);
});
