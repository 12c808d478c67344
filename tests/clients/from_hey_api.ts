/** A study by the client that @hey-api/openapi-ts generates: from_hey_api.js URL STUDY. */

import { client } from "./client/client.gen.js";
import { layouts, locations, metrics, show, submit, surface, whole } from "./client/sdk.gen.js";
import type { StudyDocument } from "./client/types.gen.js";

const [, , url = "", text = ""] = process.argv;
const body = JSON.parse(text) as StudyDocument;
client.setConfig({ baseUrl: url, throwOnError: true });

function check(held: boolean, what: string): void {
  if (!held) throw new Error(what);
}

const { id } = (await submit({ body, throwOnError: true })).data;
const path = { id };
const state = async () => (await show({ path, throwOnError: true })).data.state;
for (let now = await state(); now !== "done"; now = await state()) {
  check(now === "queued" || now === "running", now);
  await new Promise((wake) => setTimeout(wake, 50));
}
check((await whole({ path, throwOnError: true })).data.study.id === id, "the result is of another study");
check((await locations({ path, throwOnError: true })).data.locations[0]?.rank === 1, "no location is first");
check((await layouts({ path, throwOnError: true })).data.layouts !== undefined, "there are no layouts");
check(((await surface({ path, throwOnError: true })).data as Blob).size > 4, "the surface is empty");
check((await metrics({ throwOnError: true })).response.status === 200, "nothing is measured");
