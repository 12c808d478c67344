import assert from "node:assert/strict";
import { test } from "node:test";
import { accuracyOf, parseDraft, textOf, withAccuracy } from "./draft-text.ts";

test("the accuracy preset is read and replaced, whatever stood there", () => {
  const text = textOf({ name: "n", accuracy: { tolerance: 0.02 } });
  assert.equal(accuracyOf(text), null);
  assert.equal(accuracyOf(withAccuracy(text, "draft")), "draft");
  assert.deepEqual(JSON.parse(withAccuracy(text, "draft")), { name: "n", accuracy: { preset: "draft" } });
});

test("text that isn't a document is left alone and says why", () => {
  assert.equal(withAccuracy("{ name", "draft"), "{ name");
  assert.equal(withAccuracy("[1]", "draft"), "[1]");
  const parsed = parseDraft("{ name");
  assert.ok("fault" in parsed && parsed.fault.detail.startsWith("This is not JSON yet"));
});
