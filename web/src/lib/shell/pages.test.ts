import assert from "node:assert/strict";
import { test } from "node:test";
import { changedPage, mergePages, type Page } from "./pages.ts";

interface Entry {
  id: string;
  state: string;
}

const page = (entries: [string, string][], next_cursor: string | null): Page<Entry> => ({
  entries: entries.map(([id, state]) => ({ id, state })),
  next_cursor,
});

test("newer entries replace those that are known, and older ones stay with their cursor", () => {
  const merged = mergePages(
    page(
      [
        ["b", "running"],
        ["a", "done"],
      ],
      "before a",
    ),
    page(
      [
        ["c", "queued"],
        ["b", "done"],
      ],
      "before b",
    ),
  );
  assert.deepEqual(
    merged,
    page(
      [
        ["c", "queued"],
        ["b", "done"],
        ["a", "done"],
      ],
      "before a",
    ),
  );
});

test("what a newer page leaves out was removed, and what lies behind it stays", () => {
  const older = page(
    [
      ["d", "done"],
      ["c", "done"],
      ["b", "done"],
      ["a", "done"],
    ],
    "before a",
  );
  const newer = page(
    [
      ["d", "done"],
      ["b", "done"],
    ],
    "before b",
  );
  assert.deepEqual(
    mergePages(older, newer),
    page(
      [
        ["d", "done"],
        ["b", "done"],
        ["a", "done"],
      ],
      "before a",
    ),
  );
  assert.deepEqual(mergePages(older, page([], null)), page([], null));
});

test("a page that holds all of the older one has the say about what follows", () => {
  const newer = page(
    [
      ["b", "done"],
      ["a", "done"],
    ],
    null,
  );
  assert.deepEqual(mergePages(page([["a", "queued"]], "before a"), newer), newer);
});

test("an entry that was changed keeps its place, and one that isn't listed any more leaves it", () => {
  const shown = {
    entries: [
      { id: "2", name: "b" },
      { id: "1", name: "a" },
    ],
    next_cursor: "1",
  };
  assert.deepEqual(changedPage(shown, "2", { id: "2", name: "c" }), {
    ...shown,
    entries: [
      { id: "2", name: "c" },
      { id: "1", name: "a" },
    ],
  });
  assert.deepEqual(changedPage(shown, "2", null), { ...shown, entries: [{ id: "1", name: "a" }] });
  assert.deepEqual(changedPage(shown, "0", null), shown);
});
