import assert from "node:assert/strict";
import { test } from "node:test";
import { parseRoute } from "../../route.ts";
import { pageTitle } from "./page-title.ts";

const title = (address: string, change = {}): string => pageTitle(parseRoute(address), { name: null, answer: null, isMissing: false, ...change });

test("a title names what is open, and a study's its answer or its section", () => {
  const study = { name: "wall 2.5 mm", answer: "30 films along x" };
  assert.equal(title("#/studies/1", study), "wall 2.5 mm: 30 films along x - strainsite");
  assert.equal(title("#/studies/1", { name: "wall 2.5 mm" }), "wall 2.5 mm - strainsite");
  assert.equal(title("#/studies/1/layouts", study), "wall 2.5 mm: layouts - strainsite");
  assert.equal(title("#/sweeps/1", { name: "walls" }), "walls - strainsite");
  assert.equal(title("#/compare?studies=1,2,3"), "Comparison of 3 studies - strainsite");
});

test("pages without a name, and what has none yet, are called by what they are", () => {
  const titles = ["#/", "#/studies/1", "#/compare", "#/forces", "#/forces/1", "#/model", "#/nowhere"].map((address) => title(address).split(" - ")[0]);
  assert.deepEqual(titles, ["New study", "Study", "Compare studies", "Forces", "Estimator", "Your model", "Page not found"]);
});

test("what the service doesn't have is said to be missing", () => {
  assert.equal(title("#/sweeps/1", { isMissing: true }), "Sweep not found - strainsite");
});
