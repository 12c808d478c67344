// Makes src/wire.ts from openapi.json, the service's own description: the types of what it sends, the ranges of a scene's numbers, the columns of tables.
// Plain, it first asks the service at STRAINSITE_URL for the description; with --check it only says whether both are up to date.
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import openapiTS, { astToString } from "openapi-typescript";

const SERVICE = process.env.STRAINSITE_URL ?? "http://127.0.0.1:8080";
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

/** The range of each number of a document, by its place, `*` for any item of a list. */
function rangesIn(schemas, schema, place, found = new Map()) {
  const referred = schema.$ref?.split("/").at(-1);
  if (referred !== undefined) return rangesIn(schemas, schemas[referred], place, found);
  if (schema.minimum !== undefined) addRange(found, place, [schema.minimum, schema.maximum]);
  for (const variant of [...(schema.anyOf ?? []), ...(schema.oneOf ?? [])]) rangesIn(schemas, variant, place, found);
  for (const [name, field] of Object.entries(schema.properties ?? {})) rangesIn(schemas, field, place === "" ? name : `${place}/${name}`, found);
  if (schema.items !== undefined) rangesIn(schemas, schema.items, `${place}/*`, found);
  return found;
}

function addRange(found, place, range) {
  const other = found.get(place);
  if (other !== undefined && String(other) !== String(range)) throw new Error(`${place} has the ranges ${other} and ${range}`);
  found.set(place, range);
}

function rangesOf({ components: { schemas } }) {
  const lines = [...rangesIn(schemas, schemas.SceneDocument, "")].map(([place, [low, high]]) => `  "${place}": [${low}, ${high}],\n`);
  return `\n/** What the service takes for each number of a scene: lowest, highest. */\nexport const RANGES = {\n${lines.join("")}} as const;\n`;
}

/** Columns of a table by name: where their values stand in a row, and how people are shown them. */
function columnsOf([table, { columns }]) {
  const lines = columns.map(({ name, exported: _, ...column }) => `  ${name}: ${JSON.stringify(column)},\n`);
  return `\n/** Columns of ${table.replace("_", " ")}. */\nexport const ${table.toUpperCase()}_COLUMNS = {\n${lines.join("")}} as const;\n`;
}

async function moduleOf(description) {
  const types = await typesOf(description);
  return types + rangesOf(description) + Object.entries(description["x-tables"]).map(columnsOf).join("");
}

if (process.argv.includes("--check")) {
  const description = JSON.parse(readFileSync(DESCRIPTION, "utf8"));
  if (readFileSync(TYPES, "utf8") !== (await moduleOf(description))) {
    console.error('src/wire.ts is not what openapi.json gives. Start "strainsite serve", run "npm run wire" and commit both.');
    process.exitCode = 1;
  }
} else {
  const answer = await fetch(`${SERVICE}/openapi.json`);
  if (!answer.ok) throw new Error(`${SERVICE} answers ${answer.status}`);
  const description = await answer.json();
  writeFileSync(DESCRIPTION, `${JSON.stringify(description, null, 1)}\n`);
  writeFileSync(TYPES, await moduleOf(description));
}
