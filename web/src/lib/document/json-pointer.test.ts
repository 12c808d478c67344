import assert from "node:assert/strict";
import { test } from "node:test";
import { locate, pointerKeys, tomlKey } from "./json-pointer.ts";

const text = `{
  "name": "a \\"quoted\\" {name}",
  "inputs": [
    { "name": "P1", "distribution": { "min": 0.7, "max": -1e3 } },
    { "name": "P2", "a/b": [true, null, []] }
  ]
}`;

function found(pointer: string): string {
  const span = locate(text, pointer);
  assert.ok(span);
  return text.slice(span.start, span.end);
}

test("a pointer finds its value", () => {
  assert.equal(found("/name"), '"a \\"quoted\\" {name}"');
  assert.equal(found("/inputs/0/distribution/max"), "-1e3");
  assert.equal(found("/inputs/1/a~1b/1"), "null");
  assert.equal(found("/inputs/1/a~1b/2"), "[]");
  assert.equal(found(""), text);
});

test("the line counts from one", () => {
  assert.equal(locate(text, "/inputs/1/name")?.line, 5);
  assert.equal(locate(text, "/name")?.line, 2);
});

test("a member that is missing is shown at what encloses it", () => {
  assert.equal(found("/inputs/0/distribution/kind"), '{ "min": 0.7, "max": -1e3 }');
  assert.equal(found("/inputs/7"), found("/inputs"));
  assert.equal(found("/name/deeper"), found("/name"));
});

test("text that is not JSON has no places", () => {
  assert.equal(locate("{ name: 1 }", "/name"), null);
});

test("escapes of a pointer are undone in the right order", () => {
  assert.deepEqual(pointerKeys("/a~01/b~1c"), ["a~1", "b/c"]);
  assert.deepEqual(pointerKeys("#/scene"), ["scene"]);
});

test("a pointer is shown as TOML writes keys", () => {
  assert.equal(tomlKey("/inputs/0/name"), "inputs[0].name");
  assert.equal(tomlKey("/set/geometry.wall_mm/a~1b"), 'set."geometry.wall_mm"."a/b"');
  assert.equal(tomlKey(""), "");
});
