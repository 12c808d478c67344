import assert from "node:assert/strict";
import { test } from "node:test";
import { methodName, statusName } from "./output-words.ts";

test("every method and every status of the service has words of its own", () => {
  const methods = ["mdrm", "additive", "shifted", "corrected", "bivariate", "tensor", "pce", "saltelli"];
  assert.equal(new Set(methods.map(methodName)).size, methods.length);
  assert.ok(methods.every((method) => methodName(method) !== method));
  assert.match(statusName("unusable"), /no indices/);
  assert.match(statusName("constant"), /no variance/);
  assert.equal(statusName("product-form-broken"), "product form broken");
});

test("a name of a later version is shown as it came", () => {
  assert.equal(methodName("kriging"), "kriging");
  assert.equal(statusName("refuted"), "refuted");
});
