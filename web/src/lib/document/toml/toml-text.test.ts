import assert from "node:assert/strict";
import { test } from "node:test";
import { readToml, tomlOf } from "./toml-text.ts";

const DOCUMENT = {
  name: "wall",
  scene: { preset: "foot-tire", geometry: { wall_mm: 2.5 } },
  inputs: [
    { name: "P2", vary: "ground.depths_mm[1]" },
    { name: "P3", vary: "x" },
  ],
};

test("a document goes to TOML and back as it was", () => {
  const toml = tomlOf(JSON.stringify(DOCUMENT), null);
  assert.match(toml, /\[\[inputs\]\]\nname = "P2"/);
  const read = readToml(toml);
  assert.deepEqual([JSON.parse(read.of), read.fault], [DOCUMENT, null]);
});

test("what was typed stays, comments too, until the draft is another", () => {
  const read = readToml('# a try\nname = "wall"\n');
  assert.equal(tomlOf(read.of, read), '# a try\nname = "wall"\n');
  assert.equal(tomlOf('{"name":"rim"}', read), 'name = "rim"\n');
});

test("a fault has its line, and leaves no document to run", () => {
  const read = readToml('name = "wall"\nscene = {\n');
  assert.match(read.fault?.detail ?? "", /^This is not TOML yet\. Line [23], column \d+: /);
  assert.equal(read.of, read.typed);
  assert.throws(() => JSON.parse(read.of));
});

test("what JSON hasn't is a fault with its key", () => {
  assert.equal(readToml("[method]\nnodes = nan").fault?.detail, "method.nodes is NaN: a number of a document is finite.");
  assert.equal(readToml("loads_n = [1, inf]").fault?.detail, "loads_n[1] is Infinity: a number of a document is finite.");
  assert.equal(readToml("day = 2026-11-23").fault?.detail, "day is a date, which no field takes.");
});

test("JSON in the box of TOML is taken for what it is, and what is neither is shown as it is", () => {
  const text = JSON.stringify(DOCUMENT, null, 2);
  assert.deepEqual(readToml(text), { typed: text, of: text, fault: null });
  assert.equal(tomlOf("{ not yet", null), "{ not yet");
  assert.equal(tomlOf('{"loads_n": [null]}', null), '{"loads_n": [null]}');
});
