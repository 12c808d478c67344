// Films' signals on a study's page.
import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { openBrowser, openPage, savedTexts } from "../page.mjs";
import { startService } from "../service.mjs";

const SCREENSHOTS = fileURLToPath(new URL("../screenshots/", import.meta.url));
const STUDY = {
  name: "films",
  scene: { preset: "foot-tire" },
  inputs: [{ name: "P3", vary: "ground.depths_mm[2]", distribution: { kind: "uniform", min: 0.7, max: 1.3 } }],
  layouts: { spacings_deg: [] },
  method: { kind: "mdrm", nodes: 3, check_points: 0 },
  accuracy: { preset: "draft" },
  signals: { loads_n: [5, 10, 20], pressures_mpa: [0.15, 0.2], contact_deg: [0, 10, 20], films: ["bare", "coupled"] },
};

test("signals are drawn as curves and told in a table, on a narrow page too", { timeout: 300_000 }, async (t) => {
  mkdirSync(SCREENSHOTS, { recursive: true });
  const service = await startService();
  t.after(() => service.stop());
  const browser = await openBrowser();
  t.after(() => browser.close());
  const { page, complaints } = await openPage(browser, { viewport: { width: 1280, height: 900 } });
  const body = JSON.stringify(STUDY);
  const answer = await fetch(`${service.url}/v1/studies`, { method: "POST", headers: { "Content-Type": "application/json" }, body });
  const { id } = await answer.json();
  await page.goto(`${service.url}/#/studies/${id}/layouts`);
  const panel = page.locator('section[aria-labelledby="signals-title"]');
  await panel.waitFor({ timeout: 240_000 });
  // Two directions over load, pressure and contact angle, three positions by two films in each.
  assert.equal(await panel.locator("figure").count(), 6);
  assert.equal(await panel.locator("figure .film").count(), 36);
  assert.equal(await panel.getByRole("table", { name: "Claims about the own tire" }).locator("tbody tr").count(), 6);
  const [name] = await panel.locator("figure button").evaluateAll((all) => all.map((each) => /^Save (.*) as SVG$/.exec(each.ariaLabel)?.[1]));
  assert.match(await savedTexts(page, name), /crown .*glued, with its stiffness: left scale .*bare, following the wall: right scale/);
  await panel.screenshot({ path: `${SCREENSHOTS}signals.png` });
  await page.setViewportSize({ width: 390, height: 800 });
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.ok(wide <= 0, `the page is ${wide} px wider than its window`);
  assert.deepEqual(complaints, []);
});
