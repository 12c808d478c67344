import assert from "node:assert/strict";
import { test } from "node:test";
import { directionSets, layoutSize, listIn, setsNamed } from "./layout-fields.ts";

test("sets of directions are known by name, others stay what they are", () => {
  for (const name of ["both", "x", "y", "all"] as const) assert.equal(directionSets(setsNamed(name)), name);
  assert.equal(directionSets(undefined), "both");
  assert.equal(directionSets([["x", 45]]), "own");
});

test("lists are numbers with commas or spaces between them", () => {
  assert.deepEqual(listIn(" 30, 45 60;72 "), [30, 45, 60, 72]);
  assert.deepEqual(listIn(""), []);
  assert.equal(listIn("30, x"), null);
  assert.deepEqual(layoutSize([5, 2]), [5, 2]);
  for (const none of [undefined, [5], "5 x 2"]) assert.equal(layoutSize(none), null);
});
