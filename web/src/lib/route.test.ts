import assert from "node:assert/strict";
import { test } from "node:test";
import { formatRoute, parseRoute, studyRoute, sweepRoute, type Route } from "./route.ts";

test("an address and its view are the same thing", () => {
  const views: Route[] = [
    { view: "home", preset: null },
    { view: "home", preset: "foot-tire" },
    studyRoute("0197"),
    sweepRoute("0197"),
    { view: "sweep", id: "0197", baseline: "a b/c", shown: "difference" },
    { view: "study", id: "a b/c", direction: "y", quantity: "strain", input: "P3" },
  ];
  for (const view of views) assert.deepEqual(parseRoute(formatRoute(view)), view);
});

test("the contract's link opens a study with its direction and input", () => {
  assert.deepEqual(parseRoute("#/studies/42?direction=y&input=P3"), {
    view: "study", id: "42", direction: "y", quantity: "index", input: "P3",
  });
});

test("nonsense falls back to defaults instead of failing", () => {
  assert.deepEqual(parseRoute(""), { view: "home", preset: null });
  assert.deepEqual(parseRoute("#/nowhere/else"), { view: "home", preset: null });
  assert.deepEqual(parseRoute("#/studies/%zz?direction=up&quantity=mood"), {
    view: "study", id: "%zz", direction: "x", quantity: "index", input: null,
  });
  assert.deepEqual(parseRoute("#/sweeps/42?shown=mood"), sweepRoute("42"));
});
