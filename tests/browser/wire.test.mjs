// The types of the page are made from web/openapi.json, so it must be what the service says of itself.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { isDeepStrictEqual } from "node:util";
import { startService } from "./service.mjs";

const COMMITTED = new URL("../../web/openapi.json", import.meta.url);
const RENEWAL = "run make generate, and commit what it made";

/** Paths, schemas and what else a description has, by name. */
const partsOf = ({ paths, components, ...rest }) => ({ ...rest, ...paths, ...components.schemas, components: { ...components, schemas: null } });

function differences(one, other) {
  const names = new Set([...Object.keys(one), ...Object.keys(other)]);
  return [...names].filter((name) => !isDeepStrictEqual(one[name], other[name]));
}

test("the committed description is the one that the service serves", async (t) => {
  const service = await startService();
  t.after(() => service.stop());
  const served = await (await fetch(`${service.url}/openapi.json`)).json();
  const committed = JSON.parse(readFileSync(COMMITTED, "utf8"));
  const names = differences(partsOf(committed), partsOf(served));
  assert.equal(names.length, 0, `${names.join(", ")} differ: ${RENEWAL}`);
});
