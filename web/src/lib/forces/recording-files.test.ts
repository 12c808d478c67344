import assert from "node:assert/strict";
import { test } from "node:test";
import { columnWords, glance, withFiles } from "./recording-files.ts";

test("a glance at a recording tells columns and rows", () => {
  assert.deepEqual(glance({ file: "a.csv", text: '\uFEFFtime_s,"s1",fz_n\r\n0,1,2\r\n1,2,3\r\n' }), { columns: ["time_s", "s1", "fz_n"], rows: 2 });
  assert.deepEqual(glance({ file: "a.csv", text: "time_s,s1\n0,1" }), { columns: ["time_s", "s1"], rows: 1 });
  assert.deepEqual(glance({ file: "a.csv", text: "" }), { columns: [], rows: 0 });
});

test("many columns are told by the first and the last", () => {
  assert.equal(columnWords(["time_s", "s1", "fz_n"]), "time_s, s1, fz_n");
  assert.equal(columnWords(["time_s", ...Array.from({ length: 15 }, (_, k) => `s${k + 1}`), "fz_n"]), "time_s, s1, s2, … s15, fz_n");
});

test("a file of the same name takes the earlier one's place, and runs stand in their order", () => {
  const files = withFiles(
    [
      { file: "run10.csv", text: "a" },
      { file: "run2.csv", text: "b" },
    ],
    [{ file: "run2.csv", text: "c" }],
  );
  assert.deepEqual(files, [
    { file: "run2.csv", text: "c" },
    { file: "run10.csv", text: "a" },
  ]);
});
