import assert from "node:assert/strict";
import { test } from "node:test";
import { TERMS } from "./terms.ts";

test("every term is explained in one or two sentences that fit a small window", () => {
  for (const [name, meaning] of Object.entries(TERMS)) {
    const sentences = meaning.match(/[.](?= [A-ZµθL0-9]|$)/g)?.length ?? 0;
    assert.ok(sentences >= 1 && sentences <= 3 && meaning.length < 200, `${name}: ${sentences} sentences, ${meaning.length} letters`);
    assert.ok(meaning.endsWith("."), name);
  }
});
