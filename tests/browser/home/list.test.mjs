// The lists of studies: searched by the service, renamed, archived; the document as TOML.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { openBrowser, openPage, showTab, violations } from "../page.mjs";
import { startService } from "../service.mjs";

const LIMIT_MS = 30_000;
let service;
let browser;
let example;

before(async () => {
  service = await startService();
  browser = await openBrowser();
  example = (await (await fetch(`${service.url}/v1/presets`)).json()).studies[0].document;
  for (const name of ["wall 50%", "wall 500", "bead"]) await submit(name);
});

after(async () => {
  await browser.close();
  await service.stop();
});

/** Takes a study in and cancels it: the list shows those without a result, too. */
async function submit(name) {
  const headers = { "Content-Type": "application/json" };
  const answer = await fetch(`${service.url}/v1/studies`, { method: "POST", headers, body: JSON.stringify({ ...example, name }) });
  const { id } = await answer.json();
  await fetch(`${service.url}/v1/studies/${id}`, { method: "DELETE" });
}

const namesIn = (page) => page.locator(".study-list .entry-name").allInnerTexts();

/** Waits until the list of studies has these names. */
function lists(page, names) {
  return page.waitForFunction((wanted) => {
    const shown = [...document.querySelectorAll(".study-list .entry-name")].map((name) => name.textContent);
    return JSON.stringify(shown) === wanted;
  }, JSON.stringify(names));
}

async function openList() {
  const opened = await openPage(browser, { viewport: { width: 1280, height: 900 } });
  await opened.page.goto(service.url);
  await opened.page.locator(".study-list li").first().waitFor();
  return opened;
}

test("the service searches, one question for a word, its letters taken literally", { timeout: LIMIT_MS }, async () => {
  const { page, requests, complaints } = await openList();
  const box = page.getByLabel("Search the studies by name");
  await box.pressSequentially("WALL 50", { delay: 20 });
  await lists(page, ["wall 500", "wall 50%"]);
  const asked = new Set(
    requests
      .map((url) => new URL(url))
      .filter(({ pathname }) => pathname === "/v1/studies")
      .map(({ searchParams }) => searchParams.get("search")),
  );
  assert.deepEqual([...asked], [null, "WALL 50"]);
  await box.fill("50%");
  await lists(page, ["wall 50%"]);
  await box.fill("nothing so called");
  await page.getByText("No studies found for “nothing so called”.").waitFor();
  assert.deepEqual(await violations(page), []);
  await box.fill("");
  await lists(page, ["bead", "wall 500", "wall 50%"]);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("a study is renamed in its place by keys alone, and the focus returns", { timeout: LIMIT_MS }, async () => {
  const { page, complaints } = await openList();
  await page.getByRole("link", { name: /^bead/ }).click();
  await page.waitForFunction(() => document.title === "bead - strainsite");
  await page.getByRole("button", { name: "More for bead", exact: true }).press("Enter");
  await page.getByRole("button", { name: "Rename bead", exact: true }).press("Enter");
  await page.keyboard.type("rim");
  await page.keyboard.press("Escape");
  assert.ok((await namesIn(page)).includes("bead"), "Escape leaves the name");
  await page.keyboard.press("Enter");
  await page.getByRole("button", { name: "Rename bead", exact: true }).press("Enter");
  assert.deepEqual(await violations(page), []);
  await page.keyboard.type("bead, first try");
  await page.keyboard.press("Enter");
  await lists(page, ["bead, first try", "wall 500", "wall 50%"]);
  await page.waitForFunction(() => document.activeElement?.getAttribute("aria-label") === "More for bead, first try");
  await page.waitForFunction(() => document.title === "bead, first try - strainsite");
  const [{ id }] = (await (await fetch(`${service.url}/v1/studies?search=first+try`)).json()).studies;
  const detail = await (await fetch(`${service.url}/v1/studies/${id}`)).json();
  assert.deepEqual([detail.name, detail.document.name], ["bead, first try", "bead"]);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("a study is archived, taken back by the message, and found among the archived", { timeout: LIMIT_MS }, async () => {
  const { page, complaints } = await openList();
  const all = await namesIn(page);
  const rest = all.filter((name) => name !== "wall 500");
  const archive = async () => {
    await page.getByRole("button", { name: "More for wall 500", exact: true }).click();
    await page.getByRole("button", { name: "Archive wall 500", exact: true }).click();
    await lists(page, rest);
  };
  await archive();
  const undo = page.getByRole("button", { name: "Undo" });
  // The focus, which was on the entry, is on the way back.
  await page.waitForFunction(() => document.activeElement?.textContent === "Undo");
  assert.deepEqual(await violations(page), []);
  await undo.press("Enter");
  await lists(page, all);
  await archive();
  const archived = page.getByRole("switch", { name: "Archived" });
  await archived.check();
  await lists(page, ["wall 500"]);
  await page.getByRole("button", { name: "More for wall 500", exact: true }).click();
  await page.getByRole("button", { name: "Take back wall 500", exact: true }).click();
  await page.getByText("No archived studies.").waitFor();
  await archived.uncheck();
  await lists(page, all);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("several studies are removed by keys alone, and each is taken back or gone for good", { timeout: LIMIT_MS }, async () => {
  const { page, complaints } = await openList();
  const all = await namesIn(page);
  const [first, second, third] = all;
  const stored = async () => (await (await fetch(`${service.url}/v1/studies`)).json()).studies.map(({ name }) => name);
  const focused = (label) => page.waitForFunction((wanted) => document.activeElement?.getAttribute("aria-label") === wanted, label);
  for (const name of [first, second]) {
    await page.getByRole("button", { name: `More for ${name}`, exact: true }).press("Enter");
    await page.getByRole("button", { name: `Remove ${name}`, exact: true }).press("Enter");
    await focused(`Undo: ${name}`);
  }
  await lists(page, [third]);
  assert.deepEqual(await stored(), all);
  assert.deepEqual(await violations(page), []);
  await page.keyboard.press("Enter");
  await lists(page, [second, third]);
  await focused(`Undo: ${first}`);
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.activeElement?.id === "list-search");
  await page.waitForFunction(() => document.querySelector(".moved") === null);
  while ((await stored()).length > 2) await page.waitForTimeout(50);
  assert.deepEqual(await stored(), [second, third]);
  await lists(page, [second, third]);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("a document is written as TOML, its faults said by line and by key", { timeout: LIMIT_MS }, async () => {
  const { page, requests, complaints } = await openPage(browser, { viewport: { width: 1280, height: 900 } });
  await page.goto(service.url);
  await showTab(page, "text");
  const json = page.getByLabel("Study document (JSON)");
  const before = JSON.parse(await json.inputValue());
  await showTab(page, "toml");
  const toml = page.getByLabel("Study document (TOML)");
  const text = await toml.inputValue();
  assert.match(text, /^\[\[inputs\]\]$/m);
  const asked = requests.length;
  await toml.fill(`# mine\n${text}`);
  await showTab(page, "text");
  assert.deepEqual(JSON.parse(await json.inputValue()), before, "the same document");
  await showTab(page, "toml");
  assert.match(await toml.inputValue(), /^# mine\n/, "the comment is there");

  await toml.fill('name = "x"\nscene = [');
  await page
    .locator("#document-faults")
    .getByText(/This is not TOML yet\. Line 2, column \d+/)
    .waitFor();
  await page.getByRole("button", { name: "Run study" }).click({ force: true });
  await toml.fill(text.replace(/^vary = .*$/m, 'vary = "ground.depth"'));
  await page
    .locator("#document-faults code")
    .filter({ hasText: /^inputs\[0\]\.vary$/ })
    .waitFor();
  assert.deepEqual(await violations(page), []);
  assert.ok(!requests.slice(asked).some((url) => /\/v1\/studies\/[0-9a-f]/.test(url)), "what is no TOML isn't run");
  const refused = /status of 422/;
  assert.deepEqual(
    complaints.filter((line) => !refused.test(line)),
    [],
  );
  await page.context().close();
});
