import assert from "node:assert/strict";
import { test } from "node:test";
import { parseRoute } from "../../route.ts";
import { actionOf } from "./page-keys.ts";
import { readChoice, themeOf } from "../theme.ts";

const pressed = (key: string, change = {}) => ({ key, isModified: false, isTyping: false, ...change });
const STUDY = parseRoute("#/studies/1");

test("a digit opens a section of a study, and nothing elsewhere", () => {
  assert.deepEqual(actionOf(pressed("3"), STUDY), { does: "open", section: "layouts" });
  assert.equal(actionOf(pressed("9"), STUDY), null);
  assert.equal(actionOf(pressed("3"), parseRoute("#/")), null);
});

test("a question mark lists the keys anywhere but in a field", () => {
  assert.deepEqual(actionOf(pressed("?"), parseRoute("#/")), { does: "help" });
  assert.equal(actionOf(pressed("?", { isTyping: true }), STUDY), null);
  assert.equal(actionOf(pressed("1", { isModified: true }), STUDY), null);
});

test("the theme is the reader's, else the system's", () => {
  assert.equal(themeOf(readChoice("dark"), false), "dark");
  assert.equal(themeOf(readChoice("nonsense"), true), "dark");
  assert.equal(themeOf(readChoice(null), false), "light");
});
