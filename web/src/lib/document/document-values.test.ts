import assert from "node:assert/strict";
import { test } from "node:test";
import { pathOfPointer, resolved, valueAt, withValue } from "./document-values.ts";

const SCENES = [
  {
    name: "foot-tire",
    document: {
      geometry: { wall_mm: 3, outer_radius_mm: 50 },
      ground: { stations: 3, depths_mm: [1, 1, 1], station_spacing_mm: 5.5 },
      material: { model: "mooney-rivlin", c10_mpa: 0.144, c01_mpa: 0.036, d1_per_mpa: 0 },
    },
  },
];

test("a value is written without touching the document or its other fields", () => {
  const document = { name: "n", own: [1, { a: 2 }] };
  const changed = withValue(document, "/own/1/a", 3);
  assert.deepEqual(changed, { name: "n", own: [1, { a: 3 }] });
  assert.deepEqual(document, { name: "n", own: [1, { a: 2 }] });
  assert.deepEqual(withValue(document, "/scene/geometry/wall_mm", 4), { ...document, scene: { geometry: { wall_mm: 4 } } });
  assert.deepEqual(withValue(document, "/own/0", undefined), { name: "n", own: [{ a: 2 }] });
  assert.deepEqual(withValue(document, "/own", undefined), { name: "n" });
  assert.equal(valueAt(document, "/own/1/a"), 2);
  for (const pointer of ["/name/x", "/nowhere", "/own/7/a", "/constructor"]) assert.equal(valueAt(document, pointer), undefined);
});

test("a shipped scene stands with the document's own tables laid over it", () => {
  const document = { scene: { preset: "foot-tire", geometry: { wall_mm: 5 } } };
  const scene = valueAt(resolved(document, SCENES), "/scene");
  assert.deepEqual(valueAt(scene, "/geometry"), { wall_mm: 5, outer_radius_mm: 50 });
  assert.equal(valueAt(scene, "/preset"), undefined);
  assert.deepEqual(valueAt(resolved({ scene: "foot-tire" }, SCENES), "/scene"), SCENES[0]?.document);
  assert.deepEqual(resolved({ scene: "mine.toml" }, SCENES), { scene: "mine.toml" });
});

test("a force takes the place of depths, and another law that of the parameters", () => {
  const scene = { preset: "foot-tire", ground: { load_n: 13 }, material: { model: "yeoh", c10_mpa: 0.2 } };
  const full = resolved({ scene }, SCENES);
  assert.deepEqual(valueAt(full, "/scene/ground"), { station_spacing_mm: 5.5, load_n: 13 });
  assert.deepEqual(valueAt(full, "/scene/material"), { d1_per_mpa: 0, model: "yeoh", c10_mpa: 0.2 });
});

test("an input calls a field of the scene by its path", () => {
  const paths = ["/scene/ground/depths_mm/0", "/scene/geometry/wall_mm", "/scene/material/terms/1/mu_mpa"].map(pathOfPointer);
  assert.deepEqual(paths, ["ground.depths_mm[0]", "geometry.wall_mm", "material.terms[1].mu_mpa"]);
});
