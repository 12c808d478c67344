import assert from "node:assert/strict";
import { test } from "node:test";
import { turnedBy, VIEW_NAMES, viewOf } from "./eye/orbit.ts";
import { eyeText, orbitOf, PLAIN_SIGHT, readSight, sightText, type Sight } from "./view-address.ts";

const read = (query: string): Sight => readSight(new URLSearchParams(query));

test("what is seen and its address are the same thing", () => {
  const sights: Sight[] = [
    PLAIN_SIGHT,
    ...VIEW_NAMES.map((eye): Sight => ({ ...PLAIN_SIGHT, eye })),
    { ...PLAIN_SIGHT, layout: null },
    {
      layout: 2,
      value: 0.8125,
      scale: [-0.002, 0.0035],
      pin: { theta_deg: -12.5, phi_deg: 40 },
      factor: 2.5,
      isCut: false,
      eye: { azimuth_deg: -100.5, elevation_deg: 12, distance_mm: 2.9, target: [0, 0, -0.38] },
    },
  ];
  for (const sight of sights) assert.deepEqual(read(sightText(sight)), sight);
  assert.equal(sightText(PLAIN_SIGHT), "", "defaults are left out");
});

test("a turned eye is written as finely as it is seen, and written again alike", () => {
  const turned = turnedBy(viewOf("section", 1), 397.123456, 3.3333333);
  const text = eyeText(turned);
  assert.equal(text, "37.1,19.3,1.5,-0.8");
  assert.equal(eyeText(read(`eye=${text}`).eye), text);
  assert.deepEqual(orbitOf("side"), viewOf("side", 1));
});

test("nonsense falls back to what is seen at first", () => {
  const queries = [
    "layout=0",
    "layout=1.5",
    "layout=x",
    "at=",
    "at=1e999",
    "scale=2,1",
    "scale=1",
    "pin=1,2,3",
    "pin=a,b",
    "factor=-1",
    "factor=99",
    "cut=maybe",
    "eye=moon",
    "eye=1,2,3",
    "eye=0,95,2,0",
    "eye=0,5,0,0",
  ];
  for (const query of queries) assert.deepEqual(read(query), PLAIN_SIGHT, query);
});
