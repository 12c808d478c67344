import assert from "node:assert/strict";
import { test } from "node:test";
import { differenceNotes, namesakes } from "./namesakes.ts";

const entries = [
  { id: "3", name: "Foot tire" },
  { id: "2", name: "layouts" },
  { id: "1", name: "Foot tire" },
  { id: "0", name: "Foot tire" },
];

test("equal names are told apart by what differs from the oldest", () => {
  assert.deepEqual(
    namesakes(entries).map((group) => group.map(({ id }) => id)),
    [["3", "1", "0"]],
  );
  const documents = new Map<string, unknown>([
    ["0", { wall_mm: 3 }],
    ["1", { wall_mm: 4 }],
    ["3", { wall_mm: 3 }],
  ]);
  assert.deepEqual(
    [...differenceNotes(entries, documents)],
    [
      ["3", "the same document"],
      ["1", "wall_mm 4 instead of 3"],
    ],
  );
  assert.equal(differenceNotes(entries, new Map([["3", {}]])).size, 0, "the oldest isn't known yet");
});
