import assert from "node:assert/strict";
import { test } from "node:test";
import { columnWords, glance, textOf, withFiles } from "./recording-files.ts";

test("a glance at a recording tells columns and rows", () => {
  assert.deepEqual(glance({ file: "a.csv", text: '\uFEFFtime_s,"s1",fz_n\r\n0,1,2\r\n1,2,3\r\n' }), { columns: ["time_s", "s1", "fz_n"], rows: 2 });
  assert.deepEqual(glance({ file: "a.csv", text: "time_s,s1\n0,1" }), { columns: ["time_s", "s1"], rows: 1 });
  assert.deepEqual(glance({ file: "a.csv", text: "" }), { columns: [], rows: 0 });
});

test("a glance knows what loggers write", () => {
  const text = "# Logger 3000; rig 2\n% cell 7\nTime [ms];s1;Fz [N];\n0,5;1,5;2\n";
  assert.deepEqual(glance({ file: "a.csv", text }), { columns: ["Time [ms]", "s1", "Fz [N]"], rows: 1 });
  assert.deepEqual(glance({ file: "a.csv", text: "time_s\ts1\n0\t1" }), { columns: ["time_s", "s1"], rows: 1 });
  assert.deepEqual(glance({ file: "a.csv", text: "# nothing" }), { columns: ["#", "nothing"], rows: 0 });
});

test("a recording is read in whichever letters it is written", () => {
  const units = [..."\uFEFFa,µ\n"].map((letter) => letter.charCodeAt(0));
  const pairs = (isLittle: boolean) => Uint8Array.from(units.flatMap((unit) => (isLittle ? [unit & 0xff, unit >> 8] : [unit >> 8, unit & 0xff])));
  assert.equal(textOf(pairs(true)), "a,µ\n");
  assert.equal(textOf(pairs(false)), "a,µ\n");
  assert.equal(textOf(new TextEncoder().encode("a,µ\n")), "a,µ\n");
  assert.equal(textOf(Uint8Array.of(0x61, 0x2c, 0xb5, 0x0a)), "a,µ\n");
  // Not the euro of Windows, and long texts.
  assert.equal(textOf(new Uint8Array(20000).fill(0x80)), "\u0080".repeat(20000));
  assert.equal(textOf(new Uint8Array(0)), "");
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
