import assert from "node:assert/strict";
import { test } from "node:test";
import { csvCell, csvText } from "./csv-cells.ts";

test("what a spreadsheet would run is text and reads back the same", () => {
  for (const [text, cell] of [
    ["=HYPERLINK(1)", "'=HYPERLINK(1)"],
    ["=a,b", '"\'=a,b"'],
    ["@sum", "'@sum"],
    ["'=1", "''=1"],
    ["-2.5e-3", "-2.5e-3"],
    ["plain", "plain"],
    ["a;=1", '"a;=1"'],
    ["", ""],
  ] as const) {
    assert.equal(csvCell(text), cell);
    assert.equal(csvText(cell.replace(/^"|"$/g, "")), text);
  }
});
