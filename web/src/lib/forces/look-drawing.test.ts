import assert from "node:assert/strict";
import { test } from "node:test";
import type { ColumnLook, RecordingLook } from "../../wire.ts";
import { frameOf } from "../chart/frame.ts";
import { lookDrawing } from "./look-drawing.ts";
import { lookSentence, recordingFacts, takenWords } from "./look-words.ts";

const COLUMN: ColumnLook = {
  column: "s1",
  taken: "signal",
  measured: 3,
  empty: 0,
  texts: 0,
  least: 0,
  greatest: 10,
  lone: { count: 1, first: [{ line: 4, time_s: 109, value: 10 }] },
  suspicions: [],
};
const RECORDING: RecordingLook = {
  file: "a.csv",
  rows: 4,
  begin_s: 100,
  duration_s: 10,
  rate_hz: 1,
  gaps: { count: 1, longest: { line: 3, begin_s: 102, length_s: 5 }, first: [{ line: 3, begin_s: 102, length_s: 5 }] },
  cycles: 4,
  labelled: 0,
  columns: [COLUMN],
  notes: [],
};
const FRAME = frameOf(100, 11, { left: 0, right: 0, top: 0, bottom: 0 });

test("a band is broken by a gap, and marks stand at their times", () => {
  const series = { column: "s1", least: [0, 2, null, null, 4], greatest: [1, 3, null, null, 10] };
  const { band, gaps, lone } = lookDrawing(RECORDING, COLUMN, series, FRAME);
  assert.equal(band, "M10 9.5L30 7.5L30 8.5L10 10.5ZM90 0.5L90 6.5Z");
  assert.deepEqual(gaps, [{ x: 20, width: 50 }]);
  assert.deepEqual(
    lone.map(({ x, y }) => [x.toFixed(6), y.toFixed(6)]),
    [["90.000000", "0.500000"]],
  );
});

test("columns, recordings and all of it are told in words", () => {
  assert.equal(takenWords(COLUMN), "signal");
  assert.equal(takenWords({ ...COLUMN, taken: "time", time_unit: "milliseconds" }), "time, milliseconds made s");
  assert.equal(takenWords({ ...COLUMN, taken: "force", column: "force_g", force: "force_n", newtons: 0.00980665 }), "force, made N as force_n");
  assert.equal(takenWords({ ...COLUMN, taken: "force", column: "fz_n", force: "fz_n", newtons: 1 }), "force, N");
  assert.deepEqual(recordingFacts(RECORDING)[3], ["Gaps", "1, the longest of 5.0 s after line 3"]);
  const look = { recordings: [RECORDING], faults: [], refusals: [] };
  assert.match(lookSentence(look), /nothing looks wrong/);
  const suspect = { ...RECORDING, columns: [{ ...COLUMN, suspicions: ["dead"] }] };
  assert.match(lookSentence({ ...look, recordings: [suspect] }), /one thing looks wrong/);
  assert.match(lookSentence({ ...look, faults: [{ pointer: "", detail: "x" }] }), /Not every/);
});
