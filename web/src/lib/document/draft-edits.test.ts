import assert from "node:assert/strict";
import { test } from "node:test";
import { formatRoute, homeRoute, parseRoute } from "../route.ts";
import { changedFields, edited, editsOf } from "./draft-edits.ts";

const FIRST = {
  name: "X",
  scene: { preset: "foot-tire" },
  inputs: [{ name: "P1", distribution: { kind: "uniform", min: 0.7, max: 1.3 } }, { name: "P2" }],
  layouts: { units: [12, 24], search: null },
  method: { kind: "mdrm", nodes: 3 },
};

test("an edit says its field and its value, a new table's too", () => {
  assert.deepEqual(editsOf(FIRST, FIRST), {});
  const after = { ...FIRST, name: "my tire", scene: { preset: "foot-tire", geometry: { wall_mm: 4.5 } }, layouts: { units: [12], search: null } };
  assert.deepEqual(editsOf(FIRST, after), { "/name": "my tire", "/scene/geometry/wall_mm": "4.5", "/layouts/units": "[12]" });
});

test("any document comes back from the address of its edits", () => {
  const { method: _, ...withoutMethod } = FIRST;
  const odd = ["", " ", "4", "null", '"', "a=b&c#d?e%f+g/h,i:j", "true", "{", "[1]", "\u0000\n", "é 😀", "\ud800", "~1/~0", "undefined"];
  const documents: unknown[] = [
    withoutMethod,
    { ...FIRST, inputs: [FIRST.inputs[0]] },
    { ...FIRST, inputs: [...FIRST.inputs, { name: "P3", correlated: [null, [], {}] }] },
    { ...FIRST, inputs: [] },
    { ...FIRST, inputs: [{ ...FIRST.inputs[0], name: "renamed" }, {}] },
    { ...FIRST, layouts: { units: null, search: {} }, scene: "foot-tire", method: [] },
    { ...FIRST, layouts: null, extra: { deep: { deeper: { a: 1, b: [] }, empty: {} } } },
    { ...FIRST, "a/b": { "~c": false }, "0": 1e-12 },
    {},
    ...odd.map((name) => ({ ...FIRST, name, scene: { preset: name, more: [name] } })),
  ];
  for (const document of documents) {
    const edits = editsOf(FIRST, document);
    assert.ok(edits !== null, JSON.stringify(document));
    const route = parseRoute(formatRoute({ ...homeRoute(), preset: "foot-tire", edits }));
    assert.ok(route.view === "home");
    assert.deepEqual(edited(FIRST, route.edits), document);
  }
});

test("what no address can say has no edits", () => {
  for (const document of [null, 4, [FIRST], "text", { ...FIRST, "": 1 }, JSON.parse('{"__proto__": {"a": 1}}')]) assert.equal(editsOf(FIRST, document), null);
});

test("edits differ in the fields that say otherwise, are new or gone", () => {
  assert.equal(changedFields({ "/a": "1", "/b": "2" }, { "/a": "1", "/b": "3" }), "/b");
  assert.equal(changedFields({ "/a": "1" }, { "/c": "" }), "/a /c");
  assert.equal(changedFields({ "/a": "1" }, { "/a": "1" }), "");
});
