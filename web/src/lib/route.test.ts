import assert from "node:assert/strict";
import { test } from "node:test";
import { againRoute, compareRoute, estimatorRoute, formatRoute, homeRoute, parseRoute, SECTIONS, studyRoute, sweepRoute, type Route } from "./route.ts";
import { PLAIN_SIGHT } from "./tire/view-address.ts";

test("an address and its view are the same thing", () => {
  const views: Route[] = [
    homeRoute(),
    { ...homeRoute(), preset: "foot-tire" },
    againRoute("a b/c"),
    { ...homeRoute(), preset: "a&b", edits: { "/name": "50 % + 2 & more? #1 = é", "/layouts/units": "[12,24]", "/a~1b/0": "", "/scene": '{"x":"/"}' } },
    againRoute("0197", "0*0*90_30*-45*0"),
    { ...studyRoute("0197"), section: "layouts", films: "0*0*90_12.5*0*0" },
    compareRoute(["0197", "0198"]),
    { ...compareRoute(["0197", "0198", "0199"]), baseline: "0198", shown: "difference" },
    studyRoute("0197"),
    sweepRoute("0197"),
    { view: "sweep", id: "0197", from: 2000, baseline: "a b/c", shown: "difference", figure: "index-y" },
    { ...studyRoute("a b/c"), section: "tire", direction: "y", quantity: "strain", input: "P3" },
    { ...studyRoute("0197"), section: "tire", sight: { ...PLAIN_SIGHT, isCut: false, factor: 2, pin: { theta_deg: 3, phi_deg: -40 }, eye: "side" } },
    { ...compareRoute(["0197", "0198"]), direction: "y", quantity: "std", drawnAs: "tires", sight: { ...PLAIN_SIGHT, scale: [0, 0.002] } },
    { view: "forces" },
    { view: "own" },
    { view: "nowhere", address: "#/nowhere/else?films=1" },
    estimatorRoute("a b/c"),
    { ...estimatorRoute("0197"), force: "fz_n" },
    { ...studyRoute("0197"), section: "sheet" },
    ...SECTIONS.map((section): Route => ({ ...studyRoute("0197"), section })),
  ];
  for (const view of views) assert.deepEqual(parseRoute(formatRoute(view)), view);
});

test("the contract's link opens the map with its direction and input", () => {
  assert.deepEqual(parseRoute("#/studies/42?direction=y&input=P3"), {
    view: "study",
    id: "42",
    section: "tire",
    direction: "y",
    quantity: "index",
    input: "P3",
    films: null,
    sight: PLAIN_SIGHT,
  });
});

test("an edit can be read in its address", () => {
  const route = { ...homeRoute(), preset: "foot-tire", edits: { "/scene/geometry/wall_mm": "4.5", "/method": "" } };
  assert.equal(formatRoute(route), "#/?preset=foot-tire&/scene/geometry/wall_mm=4.5&/method=");
});

test("nonsense falls back to defaults instead of failing", () => {
  for (const address of ["", "#", "#/", "#/?mood=good", "#?mood=good"]) assert.deepEqual(parseRoute(address), homeRoute());
  assert.deepEqual(parseRoute("#/studies/%zz?direction=up&quantity=mood"), {
    view: "study",
    id: "%zz",
    section: "tire",
    direction: "x",
    quantity: "index",
    input: null,
    films: null,
    sight: PLAIN_SIGHT,
  });
  assert.deepEqual(parseRoute("#/compare"), compareRoute([]));
  assert.deepEqual(parseRoute("#/studies/42/nowhere"), studyRoute("42"));
  assert.deepEqual(parseRoute("#/sweeps/42?shown=mood"), sweepRoute("42"));
});

test("an address that names no page is told, not taken for the form", () => {
  for (const address of ["#/nowhere", "#/studies", "#/studies/", "#/forces/42/nowhere", "#/studies/42/tire/more"])
    assert.deepEqual(parseRoute(address), { view: "nowhere", address });
});
