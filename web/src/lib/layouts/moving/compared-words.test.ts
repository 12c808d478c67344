import assert from "node:assert/strict";
import { test } from "node:test";
import { comparedWords } from "./compared-words.ts";

test("better and worse are told with by how much", () => {
  const told = "At its worst load and angle the contact is known to 2° at best";
  assert.equal(comparedWords(2, 4), `${told}: better by 50 % than the 4° of the layout it came from.`);
  assert.equal(comparedWords(2, 1), `${told}: worse by 100 % than the 1° of the layout it came from.`);
  assert.equal(comparedWords(2, 2), `${told}: as the layout it came from.`);
  assert.equal(comparedWords(2, null), `${told}.`);
});

test("contacts that can't be told are worse than any error", () => {
  const blind = "There is a contact that these films can't tell";
  assert.equal(comparedWords(Infinity, 4), `${blind}: worse than the 4° of the layout it came from.`);
  assert.equal(comparedWords(Infinity, Infinity), `${blind}: as the layout it came from.`);
  assert.match(comparedWords(2, Infinity), /better than the layout it came from, which can't tell all contacts/);
});
