// A new study by its form: fields and text are one document, checked, estimated and solved on the draft mesh while it is written.
// STRAINSITE_PAGE=URL tries a page that is served elsewhere, by vite with a service behind it.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { openBrowser, openPage, showTab, showText, violations } from "../page.mjs";
import { startService } from "../service.mjs";

const SIZE = { viewport: { width: 1440, height: 900 } };
const STUDY_MS = Number(process.env.STRAINSITE_STUDY_MS ?? 600_000);
const WALL = /^Wall thickness, mm/;

let service = null;
let browser;
let url;

before(async () => {
  if (process.env.STRAINSITE_PAGE === undefined) service = await startService();
  url = process.env.STRAINSITE_PAGE ?? service.url;
  browser = await openBrowser();
});

after(async () => {
  await browser?.close();
  await service?.stop();
});

async function openForm() {
  const opened = await openPage(browser, SIZE);
  await opened.page.goto(`${url}/#/?preset=foot-tire`);
  await opened.page.getByLabel(WALL).waitFor();
  return opened;
}

async function written(page) {
  return JSON.parse(await (await showText(page)).inputValue());
}

async function writeText(page, document) {
  await (await showText(page)).fill(JSON.stringify(document));
}

test("a field writes into the text, the text into the field, and what the form doesn't know stays", async () => {
  const { page, complaints } = await openForm();
  await page.getByLabel(WALL).fill("4,5");
  const document = await written(page);
  assert.deepEqual(document.scene, { preset: "foot-tire", geometry: { wall_mm: 4.5 } });
  await writeText(page, { ...document, scene: { preset: "foot-tire", geometry: { wall_mm: 2.5 } }, method: { ...document.method, seed: 7 } });
  await showTab(page, "form");
  assert.equal(await page.getByLabel(WALL).inputValue(), "2.5");
  await page.getByLabel(/^Pressure inside, MPa/).fill("0.15");
  await page.getByLabel("P3: half-width").fill("0.4");
  const changed = await written(page);
  assert.deepEqual(changed.scene, { preset: "foot-tire", geometry: { wall_mm: 2.5 }, pressure: { internal_mpa: 0.15 } });
  assert.deepEqual(changed.inputs[2].distribution, { kind: "uniform", min: 0.6, max: 1.4 });
  assert.equal(changed.method.seed, 7);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("a fault stands at its field and in the list, and the cost beside the button", async () => {
  const { page } = await openForm();
  await page.locator(".run-cost dd").first().waitFor();
  assert.match(await page.locator(".run-cost").innerText(), /Expected time.* s.*Memory.*[MG]B.*Solves/s);
  await page.getByLabel(WALL).fill("20");
  const fault = page.locator('[data-pointer="/scene/geometry/wall_mm"] .field-fault');
  await fault.waitFor();
  assert.match(await fault.innerText(), /less than section_radius_mm/);
  assert.match(await page.locator(".fault-list").innerText(), /\/scene\/geometry\/wall_mm/);
  assert.match(await page.locator(".run-cost").innerText(), /One fault/);
  await page.getByLabel(WALL).fill("3");
  await fault.waitFor({ state: "detached" });
  await page.context().close();
});

test("a preview appears and follows the wall's slider, many edits by few solves", async (t) => {
  const { page } = await openForm();
  const force = page.locator(".preview-force");
  await force.waitFor();
  assert.match(await page.locator(".preview").innerText(), /Preview on a draft mesh, without a claim/);
  const first = await force.innerText();
  let asked = 0;
  page.on("request", (request) => (asked += Number(request.url().endsWith(":preview"))));
  const slider = page.getByLabel("Wall thickness, slider");
  const moved = await slider.evaluate(async (element) => {
    let slowest = 0;
    for (let wall = 3.1; wall < 5.05; wall += 0.1) {
      const start = performance.now();
      element.value = String(wall);
      element.dispatchEvent(new Event("input", { bubbles: true }));
      await new Promise((resolve) => setTimeout(resolve));
      slowest = Math.max(slowest, performance.now() - start);
      await new Promise((resolve) => setTimeout(resolve, 10));
    }
    return slowest;
  });
  await page.waitForFunction(
    () => /\([+−]/.test(document.querySelector(".preview-force")?.textContent ?? "") && document.querySelector(".preview .stale") === null,
  );
  const last = await force.innerText();
  t.diagnostic(`${first} became ${last}; 20 edits by ${asked} previews; the slowest edit took ${moved.toFixed(0)} ms`);
  assert.notEqual(last, first, "a thicker wall has another force and other strains");
  assert.ok(asked < 20, `${asked} previews for 20 edits`);
  assert.match(await page.locator("#study-differs").innerText(), /wall_mm 5 instead of 3/);
  await page.context().close();
});

test("a phone's first screen has the preset, the preview's answer and the button, in the order of keys", async () => {
  const { page, complaints } = await openPage(browser, { viewport: { width: 390, height: 844 } });
  await page.goto(`${url}/#/?preset=foot-tire`);
  await page.locator(".preview-answer").waitFor();
  await page.locator(".run-cost dd").first().waitFor();
  for (const part of [".presets", ".run-box", ".preview-force", ".preview-answer"]) {
    const { top, bottom } = await page.locator(part).evaluate((element) => element.getBoundingClientRect().toJSON());
    assert.ok(top >= 0 && bottom <= 844, `${part} lies from ${top} to ${bottom} px`);
  }
  assert.deepEqual(await violations(page), []);
  await page.locator('.preset input[value="foot-tire"]').focus();
  await page.keyboard.press("Tab");
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Run study");
  await page.setViewportSize({ width: 1280, height: 900 });
  await page.waitForFunction(() => document.querySelector(".new-study > :last-child")?.className === "new-study-live");
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Run study", "a wider window leaves the focus where it is");
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("a study is run again with changes, its name says which, and both are compared", { timeout: STUDY_MS }, async () => {
  const { page } = await openForm();
  const document = await written(page);
  await writeText(page, { ...document, name: "first", layouts: { spacings_deg: [] }, candidates: { points: "P1-P5" }, accuracy: { preset: "draft" } });
  await page.getByRole("button", { name: "Run study" }).click();
  await page.locator(".study-head .badge-done").waitFor({ timeout: STUDY_MS });
  await page.getByRole("link", { name: "Run again with changes" }).click();
  await showTab(page, "form");
  await page.getByLabel(WALL).fill("5");
  assert.match(await page.locator("#study-differs").innerText(), /Differs from “first”: wall_mm 5 instead of 3\. Will be called “first · wall_mm = 5”/);
  await page.getByRole("button", { name: "Run study" }).click();
  await page.getByRole("heading", { name: "first · wall_mm = 5", level: 1 }).waitFor();
  await page.locator(".study-head .badge-done").waitFor({ timeout: STUDY_MS });

  await page.getByLabel("Search the studies by name").fill("FIRST");
  for (const name of ["Compare first", "Compare first · wall_mm = 5"]) await page.getByLabel(name, { exact: true }).first().check();
  await page.getByRole("link", { name: "Compare 2 studies" }).click();
  const fields = page.getByRole("table", { name: "Documents, field by field" }).locator("tbody tr");
  await fields.first().waitFor();
  assert.deepEqual(await fields.allInnerTexts(), ["wall_mm\t3\t5"]);
  assert.equal(await page.getByRole("table", { name: "Answers of the studies" }).locator("tbody tr").count(), 2);
  await page.context().close();
});
