import assert from "node:assert/strict";
import test from "node:test";

import { type Column, heading, shown, shownError, view } from "./columns.ts";

const OFF: Column = { at: "/score/off_deg", kind: "float", unit: "deg", title: "off by", digits: 2, error_at: "/score/error/0", description: "How far off" };

test("a view has its columns in the order of the views", () => {
  const table = { late: { ...OFF, view: "b" }, none: OFF, early: { ...OFF, view: "a" } };
  assert.deepEqual(view(table, "a", "b"), [table.early, table.late]);
});

test("a heading has the title and the unit", () => {
  assert.deepEqual(heading(OFF), { text: "Off by °", title: "How far off" });
  const { description: _, ...plain } = OFF;
  assert.deepEqual(heading({ ...plain, kind: "share", unit: "1" }), { text: "Off by %" });
  assert.equal(heading({ ...OFF, unit: "1" }).text, "Off by");
});

test("a figure is read where its pointer says", () => {
  const row = { score: { off_deg: 1.234, error: [0.5] } };
  assert.equal(shown(OFF, row), "1.23");
  assert.equal(shownError(OFF, row), "0.50");
  assert.equal(shown({ ...OFF, kind: "share", digits: 1 }, row), "123.4");
  for (const empty of [{}, { score: null }, { score: { off_deg: null } }]) {
    assert.equal(shown(OFF, empty), "—");
    assert.equal(shownError(OFF, empty), undefined);
  }
});
