import assert from "node:assert/strict";
import { test } from "node:test";
import { commonDepths, furtherInput, inputsOf, meanAt, PARAMETERS, spreadOf, withCommonDepths, withKind, withSpread } from "./input-laws.ts";
import { depthFields, GEOMETRY, numberFields, numberIn, rangeWords, sliderRange, usualWords } from "./scene-fields.ts";

const DOCUMENT = {
  scene: {
    geometry: { wall_mm: 3 },
    material: { model: "mooney-rivlin", c10_mpa: 0.144, c01_mpa: 0.036, d1_per_mpa: 0 },
    ground: { stations: 3, depths_mm: [1, 1, 1] },
  },
  inputs: [{ name: "P1", vary: "ground.depths_mm[0]", distribution: { kind: "uniform", min: 0.7, max: 1.3 } }],
};

test("a document has the fields that its scene has", () => {
  assert.equal(depthFields(DOCUMENT).length, 3);
  const pointers = numberFields(DOCUMENT).map(({ pointer }) => pointer);
  assert.ok(pointers.includes("/scene/material/c01_mpa") && pointers.includes("/scene/ground/depths_mm/2"));
  assert.ok(!pointers.some((pointer) => pointer.startsWith("/scene/carcass") || pointer.endsWith("load_n")));
  const pressed = numberFields({ scene: { ground: { load_n: 13 }, carcass: {} } }).map(({ pointer }) => pointer);
  assert.ok(pressed.includes("/scene/ground/load_n") && pressed.includes("/scene/carcass/position"));
  assert.equal(new Set(pointers).size, pointers.length);
});

test("a slider reaches a value beyond the usual ones, and a box holds numbers alone", () => {
  const wall = GEOMETRY[0];
  assert.ok(wall !== undefined);
  assert.deepEqual(sliderRange(wall, 3), { from: 1, to: 6, step: 0.1 });
  assert.equal(sliderRange(wall, 9).to, 9);
  assert.equal(rangeWords({ low: 0.001, high: 10_000 }), "0.001 to 10\u202f000");
  assert.equal(usualWords({ usual: [1, 8, 0.1] }), "1 to 8");
  assert.equal(rangeWords({ low: 1e-6, high: 1e9 }), "1e−6 to 1e9");
  assert.equal(rangeWords({ low: -1e6, high: 1e6 }), "−1\u202f000\u202f000 to 1\u202f000\u202f000");
  assert.deepEqual([" 2,5 ", "1e-3", "", "3 mm", "Infinity"].map(numberIn), [2.5, 0.001, null, null, null]);
});

test("a spread is read and written back, whatever else the distribution says", () => {
  const uniform = { kind: "uniform", min: 0.7, max: 1.3, truncate: [0, 2] };
  assert.deepEqual(spreadOf(uniform), { centre: 1, half: 0.3 });
  assert.deepEqual(withSpread(uniform, { centre: 2, half: 0.5 }), { kind: "uniform", min: 1.5, max: 2.5, truncate: [0, 2] });
  assert.deepEqual(withSpread({ kind: "normal", mean: 1, std: 0.1 }, { centre: 2, half: 0.2 }), { kind: "normal", mean: 2, std: 0.2 });
  assert.equal(spreadOf({ kind: "gamma", shape: 2, scale: 1 }), null);
});

test("every kind is made with all of its parameters", () => {
  for (const [kind, parameters] of Object.entries(PARAMETERS)) {
    const made = withKind({ kind: "uniform", min: 0.7, max: 1.3 }, kind);
    assert.deepEqual(Object.keys(made).sort(), ["kind", ...parameters].sort(), kind);
    assert.ok(
      parameters.every((name) => Number.isFinite(made[name])),
      kind,
    );
  }
});

test("a further input varies a field that doesn't yet, about its value", () => {
  const fields = numberFields(DOCUMENT);
  assert.deepEqual(furtherInput(DOCUMENT, fields), {
    name: "wall_mm",
    vary: "geometry.wall_mm",
    distribution: { kind: "uniform", min: 2.1, max: 3.9 },
  });
  const depths = depthFields(DOCUMENT);
  assert.equal(furtherInput(DOCUMENT, depths)?.vary, "ground.depths_mm[1]");
  assert.equal(furtherInput(DOCUMENT, depths.slice(0, 1)), null);
});

test("a field that varies stands at its distribution's centre", () => {
  assert.deepEqual(meanAt(DOCUMENT, "/scene/ground/depths_mm/0"), { value: 1, half: 0.3 });
  assert.deepEqual(meanAt(DOCUMENT, "/scene/geometry/wall_mm"), { value: 3, half: 0 });
  assert.equal(meanAt(DOCUMENT, "/scene/nothing"), null);
  assert.deepEqual(inputsOf({ inputs: [7] }), [{ name: "", vary: "", distribution: {} }]);
});

test("contact depths that share a spread are moved together, other inputs aren't", () => {
  const uniform = { kind: "uniform", min: 0.7, max: 1.3 };
  const depth = (index: number) => ({ name: `P${index}`, vary: `ground.depths_mm[${index}]`, distribution: uniform });
  const inputs = [depth(0), depth(1), { name: "wall", vary: "geometry.wall_mm", distribution: { kind: "uniform", min: 2, max: 4 } }];
  assert.deepEqual(commonDepths(inputs), { centre: 1, half: 0.3 });
  const moved = withCommonDepths(inputs, { centre: 2, half: 0.5 });
  assert.deepEqual(
    moved.slice(0, 2),
    [0, 1].map((index) => ({ ...depth(index), distribution: { kind: "uniform", min: 1.5, max: 2.5 } })),
  );
  assert.equal(moved[2], inputs[2]);
  assert.equal(commonDepths([depth(0)]), null);
  assert.equal(commonDepths([depth(0), { ...depth(1), distribution: { kind: "uniform", min: 0, max: 1.3 } }]), null);
});
