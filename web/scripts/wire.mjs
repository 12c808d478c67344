// Makes src/wire.ts, the types of what the service sends, from openapi.json, the service's own description.
// Plain, it first asks the service at STRAINSITE_URL for the description; with --check it only says whether the types are up to date.
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import openapiTS, { astToString } from "openapi-typescript";

const SERVICE = process.env["STRAINSITE_URL"] ?? "http://127.0.0.1:8080";
const DESCRIPTION = fileURLToPath(new URL("../openapi.json", import.meta.url));
const TYPES = fileURLToPath(new URL("../src/wire.ts", import.meta.url));
const HEAD = "// Made from openapi.json by `npm run wire`; not edited by hand.\n\n";

async function typesOf(description) {
  const { openapi, info, components } = description;
  // Only documents: addresses and methods are in api.ts.
  const syntax = await openapiTS(
    { openapi, info, paths: {}, components: { schemas: components.schemas } },
    { emptyObjectsUnknown: true, rootTypes: true, rootTypesNoSchemaPrefix: true, rootTypesKeepCasing: true },
  );
  return HEAD + astToString(syntax);
}

if (process.argv.includes("--check")) {
  const committed = readFileSync(TYPES, "utf8");
  if (committed !== (await typesOf(JSON.parse(readFileSync(DESCRIPTION, "utf8"))))) {
    console.error('src/wire.ts is not what openapi.json gives. Start "strainsite serve", run "npm run wire" and commit both.');
    process.exitCode = 1;
  }
} else {
  const answer = await fetch(`${SERVICE}/openapi.json`);
  if (!answer.ok) throw new Error(`${SERVICE} answers ${answer.status}`);
  const description = await answer.json();
  writeFileSync(DESCRIPTION, `${JSON.stringify(description, null, 1)}\n`);
  writeFileSync(TYPES, await typesOf(description));
}
