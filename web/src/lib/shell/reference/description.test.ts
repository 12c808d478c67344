import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { documentOf, exampleText, firstLines, matching, operations, type Description } from "./description.ts";

const described = JSON.parse(readFileSync("openapi.json", "utf8")) as Description;

test("every operation is listed once, those of studies first", () => {
  const all = operations(described);
  const counted = Object.values(described.paths).flatMap((item) => Object.keys(item));
  assert.equal(all.length, counted.length);
  assert.equal(new Set(all.map(({ id }) => id)).size, all.length);
  assert.equal(all[0]?.tags?.[0], "studies");
  assert.equal(all.at(-1)?.tags?.[0], "service");
});

test("a filter needs all of its words, anywhere", () => {
  const all = operations(described);
  const found = matching(all, "POST  studies estimate").map(({ method, path }) => `${method} ${path}`);
  assert.ok(found.includes("POST /v1/studies:estimate"), found.join(", "));
  assert.ok(
    found.every((name) => name.startsWith("POST")),
    found.join(", "),
  );
  assert.deepEqual(matching(all, ""), all);
  assert.deepEqual(matching(all, "no such thing anywhere"), []);
});

test("a body's document is named, of a list that of its entries, and nothing else is a link", () => {
  assert.equal(documentOf({ schema: { $ref: "#/components/schemas/StudyResult" } }), "StudyResult");
  assert.equal(documentOf({ schema: { type: "array", items: { $ref: "#/components/schemas/RankedLayout" } } }), "RankedLayout");
  assert.equal(documentOf({ schema: { type: "string" } }), null);
  assert.equal(documentOf({}), null);
});

test("examples are shown as they are sent", () => {
  assert.equal(exampleText({ example: "name = 1" }), "name = 1");
  assert.equal(exampleText({ example: { a: [1] } }), '{\n  "a": [\n    1\n  ]\n}');
  assert.equal(exampleText({ example: false }), "false");
  assert.equal(exampleText({}), null);
});

test("the first lines ask the service that sent the page, by addresses that it has", () => {
  const lines = firstLines("http://127.0.0.1:9").split("\n");
  assert.equal(lines.length, 5);
  for (const line of lines) {
    const path = /http:\/\/127\.0\.0\.1:9(\/[^\s?"]*)/.exec(line)?.[1] ?? "";
    assert.ok(path.replace("$ID", "{id}") in described.paths, line);
  }
});
