// The draft of a new study in the address: reloaded, gone back in, sent.
// STRAINSITE_PAGE=URL tries a page that is served elsewhere, by vite with a service behind it.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { openBrowser, openPage, showTab, showText } from "../page.mjs";
import { startService } from "../service.mjs";

const WALL = /^Wall thickness, mm/;
const PRESSURE = /^Pressure inside, MPa/;
/** Edits of a field that come sooner after one another are one step back. */
const STEP_MS = 1100;

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

async function openForm(address = "") {
  const opened = await openPage(browser, { viewport: { width: 1280, height: 900 } });
  await opened.page.goto(`${url}/${address}`);
  await opened.page.getByLabel(WALL).waitFor();
  return opened;
}

/** The browser itself writes to its console what the service refuses of drafts on the way, and of two pages that ask at once. */
const faults = (complaints) => complaints.filter((line) => !/status of 4(09|22) .*(:estimate|:preview)$/.test(line));

/** What the form and the text say of a draft. */
async function shown(page) {
  await showTab(page, "form");
  const fields = [await page.getByLabel(WALL).inputValue(), await page.getByLabel(PRESSURE).inputValue()];
  const text = await (await showText(page)).inputValue();
  await showTab(page, "form");
  return { fields, text };
}

async function sees(page, wall, pressure) {
  await page.waitForFunction(
    ([wallNow, pressureNow]) => {
      const value = (pointer) => document.querySelector(`[data-pointer="${pointer}"] .number-box`)?.value;
      return value("/scene/geometry/wall_mm") === wallNow && value("/scene/pressure/internal_mpa") === pressureNow;
    },
    [wall, pressure],
  );
}

test("an edited draft is the same after a reload, from a sent address, and a step back undoes an edit", async () => {
  const { page, complaints } = await openForm();
  await page.getByLabel(WALL).fill("4.5");
  await page.getByLabel(PRESSURE).fill("0.15");
  await page.waitForURL(/internal_mpa=0.15/);
  await page.getByLabel("Name", { exact: true }).fill("wall & pressure = new, 50 %?");
  await page.waitForURL(/name=/);
  assert.match(page.url(), /#\/\?preset=foot-tire&\/.*\/scene\/geometry\/wall_mm=4\.5/);
  const edited = await shown(page);
  const sent = page.url();

  await page.reload();
  await page.getByLabel(WALL).waitFor();
  assert.deepEqual(await shown(page), edited);
  const other = await openForm(new URL(sent).hash);
  assert.deepEqual(await shown(other.page), edited);
  assert.deepEqual(faults(other.complaints), []);
  await other.page.context().close();

  await page.goBack();
  await page.waitForFunction(() => !document.querySelector("#study-name").value.startsWith("wall"));
  await sees(page, "4.5", "0.15");
  await page.goBack();
  await sees(page, "4.5", "0.2");
  await page.goBack();
  await sees(page, "3", "0.2");
  assert.match(page.url(), /#\/\?preset=foot-tire$/);
  for (const _ of [1, 2, 3]) await page.goForward();
  await page.waitForFunction(() => document.querySelector("#study-name").value.startsWith("wall"));
  assert.deepEqual(await shown(page), edited);
  assert.deepEqual(faults(complaints), []);
  await page.context().close();
});

test("a slider is one step from rest to rest, with few writes, and a box that is being typed in goes back too", async (t) => {
  const { page, complaints } = await openForm();
  await page.evaluate(() => {
    globalThis.writes = { pushState: 0, replaceState: 0 };
    for (const name of Object.keys(globalThis.writes)) {
      const write = history[name].bind(history);
      history[name] = (...given) => {
        globalThis.writes[name] += 1;
        write(...given);
      };
    }
  });
  const slide = (from, to) =>
    page.getByLabel("Wall thickness, slider").evaluate(
      async (element, [first, last]) => {
        for (let k = 0; k <= 100; k += 1) {
          element.value = String(first + ((last - first) * k) / 100);
          element.dispatchEvent(new Event("input", { bubbles: true }));
          await new Promise((resolve) => setTimeout(resolve, 10));
        }
      },
      [from, to],
    );
  const start_ms = Date.now();
  await slide(3, 4);
  await page.waitForURL(/wall_mm=4$/);
  await page.waitForTimeout(STEP_MS);
  await slide(4, 5);
  await page.waitForURL(/wall_mm=5$/);
  const writes = await page.evaluate(() => globalThis.writes);
  t.diagnostic(`202 edits were written by ${writes.pushState} steps and ${writes.replaceState} replacements`);
  assert.equal(writes.pushState, 2);
  // Browsers refuse more than 100 in 30 s.
  const most = 2 + Math.ceil((Date.now() - start_ms) / 300);
  assert.ok(writes.pushState + writes.replaceState <= most, `${writes.replaceState} replacements`);
  await page.waitForTimeout(STEP_MS);
  await page.getByLabel(WALL).fill("6");
  await page.goBack();
  await sees(page, "5", "0.2");
  await page.goBack();
  await sees(page, "4", "0.2");
  await page.goBack();
  await sees(page, "3", "0.2");
  assert.deepEqual(faults(complaints), []);
  await page.context().close();
});

test("a draft waits while another view is open, and a text that is no document stays out of the address", async () => {
  const { page, complaints } = await openForm();
  await page.locator('.preset input[value="layouts"]').check();
  await page.waitForURL(/preset=layouts$/);
  await page.getByRole("link", { name: "Forces", exact: true }).click();
  await page.getByRole("link", { name: "New study", exact: true }).click();
  await page.waitForURL(/preset=layouts$/);
  for (const _ of [1, 2, 3]) await page.goBack();
  await page.locator('.preset input[value="foot-tire"]:checked').waitFor();
  await page.getByLabel(WALL).fill("4");
  await page.waitForURL(/wall_mm=4$/);
  const address = page.url();
  const text = await showText(page);
  const written = await text.inputValue();
  await text.fill("{ no document");
  await page.getByRole("link", { name: "Forces", exact: true }).click();
  await page.getByRole("heading", { level: 1, name: /forces/i }).waitFor();
  await page.goBack();
  await text.waitFor();
  assert.equal(await text.inputValue(), "{ no document");
  assert.equal(page.url(), address);
  // An address that says nothing of a draft leads to the one that is being written.
  await text.fill(JSON.stringify({ ...JSON.parse(written), name: "x".repeat(9000) }));
  await page.waitForTimeout(500);
  assert.equal(page.url(), address);
  await text.fill(JSON.stringify({ scene: { preset: "foot-tire" } }));
  await page.waitForURL(/inputs=&/);
  await page.getByRole("link", { name: "Forces", exact: true }).click();
  await page.getByRole("link", { name: "New study", exact: true }).click();
  await page.waitForURL(/inputs=&/);
  assert.deepEqual(JSON.parse(await text.inputValue()), { scene: { preset: "foot-tire" } });
  assert.deepEqual(faults(complaints), []);
  await page.context().close();
});
