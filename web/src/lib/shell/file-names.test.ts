import assert from "node:assert/strict";
import { test } from "node:test";
import { csvOf, fileName } from "./file-names.ts";

test("a file is named by study and figure in plain letters", () => {
  assert.equal(fileName("foot tire, 1 mm +-30 %", "Indices x", "svg"), "foot-tire-1-mm-30-indices-x.svg");
  assert.equal(fileName("日本", "map", "png"), "study-map.png");
  assert.ok(fileName("a".repeat(200), "map", "png").length < 60);
});

test("cells with commas and quotes are quoted, minus signs are plain", () => {
  assert.equal(
    csvOf([
      ["a", 'say "b", c'],
      ["−1.5", " two\n lines "],
    ]),
    'a,"say ""b"", c"\r\n-1.5,two lines\r\n',
  );
});
