// Layouts on a study's page: the answer in a sentence, the plot, the tables.
import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { openBrowser, openPage } from "./page.mjs";
import { startService } from "./service.mjs";

const SCREENSHOTS = fileURLToPath(new URL("screenshots/", import.meta.url));
const STUDY = {
  name: "layouts",
  scene: { preset: "foot-tire" },
  inputs: [{ name: "depth", vary: "ground.depths_mm[2]", distribution: { kind: "uniform", min: 0.7, max: 1.3 } }],
  layouts: {
    depths_mm: [1, 2], spacings_deg: [90, 60, 30], units: [8, 9], positions: ["crown", "sidewall"], directions: [["x", "y"], ["y"]], staggered: true,
    search: { films: [3], slots: 12, section_deg: [0], directions: ["x", "y"] },
  },
  method: { kind: "mdrm", nodes: 3, check_points: 0 },
  accuracy: { preset: "draft" },
};

test("layouts are answered in a sentence, drawn over their units, and listed", { timeout: 600_000 }, async (t) => {
  mkdirSync(SCREENSHOTS, { recursive: true });
  const service = await startService();
  t.after(() => service.stop());
  const browser = await openBrowser();
  t.after(() => browser.close());
  const { page, complaints } = await openPage(browser, { viewport: { width: 1280, height: 900 } });
  const body = JSON.stringify(STUDY);
  const answer = await fetch(`${service.url}/v1/studies`, { method: "POST", headers: { "Content-Type": "application/json" }, body });
  const { id } = await answer.json();
  await page.goto(`${service.url}/#/studies/${id}`);
  const panel = page.locator('section[aria-labelledby="layouts-title"]');
  await panel.waitFor({ timeout: 540_000 });
  const { layouts, findings } = await (await fetch(`${service.url}/v1/studies/${id}/layouts`)).json();

  // A study with one input is one of layouts: they stand before the ranking of locations.
  const titles = await page.locator("main section h2").allInnerTexts();
  assert.ok(titles.indexOf("Layouts around the wheel") < titles.indexOf("Ranking"), titles.join(", "));
  const [best] = layouts;
  const [first, papers] = await panel.locator(".layout-answer p").allInnerTexts();
  t.diagnostic(`${first} | ${papers}`);
  const digits = (value) => String(Number(value.toPrecision(Math.max(2, Math.floor(Math.log10(value)) + 1))));
  assert.match(first, new RegExp(`${best.units} units of .* at the ${best.position}, every ${best.spacing_deg}°`));
  assert.ok(first.includes(`the contact angle to ${digits(best.score.simulated_p95_angle_error_deg)}`), first);
  assert.ok(first.includes(`as force ${digits(best.score.force_error_n)} N`), first);
  assert.match(papers, /The paper's layout, 6 units of x and y at the crown, every 60°, ranks \d+ of \d+: it would know the contact angle to [\d.]+/);

  // Two positions by three sets of films, each over five numbers of units; y alone isn't staggered.
  const plot = panel.locator("svg.layout-plot");
  const points = () => plot.locator("title").allTextContents();
  assert.equal(await plot.locator(".layout-curve").count(), 6);
  assert.equal((await points()).length, layouts.filter((layout) => layout.spacing_deg !== null).length);
  assert.equal(await plot.locator(".papers-mark").count(), 1);
  assert.match(await plot.locator(".axis .papers").textContent(), /6.*60°/);
  const atWorst = await points();
  await panel.getByRole("radio", { name: "1 mm" }).focus();
  await page.keyboard.press("Space");
  await panel.locator("figcaption").filter({ hasText: "at 1 mm" }).waitFor();
  assert.notDeepEqual(await points(), atWorst, "another load has other errors");
  await panel.screenshot({ path: `${SCREENSHOTS}layouts.png` });

  const ranked = panel.getByRole("table", { name: "Ranked layouts" }).locator("tbody tr");
  assert.equal(await ranked.count(), 20);
  await panel.getByRole("button", { name: `Show all ${layouts.length} layouts` }).click();
  assert.equal(await ranked.count(), layouts.length);
  const rowsOf = (name) => panel.getByRole("table", { name }).locator("tbody tr").count();
  assert.equal(await rowsOf("Best layout for each number of films"), findings.front.length);
  assert.equal(await rowsOf("From how many units on a ring is dense enough"), findings.loads[0].knees.length);
  assert.equal(await rowsOf("Searched layouts"), 1);
  assert.equal(await rowsOf("Kinds of film by several criteria"), findings.candidates.length);
  assert.equal(await rowsOf("Kendall's tau between criteria"), 6);

  await page.setViewportSize({ width: 390, height: 800 });
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.ok(wide <= 0, `the page is ${wide} px wider than its window`);
  assert.deepEqual(complaints, []);
});

test("bounds of a result of an earlier version are a table", { timeout: 60_000 }, async (t) => {
  const service = await startService();
  t.after(() => service.stop());
  const browser = await openBrowser();
  t.after(() => browser.close());
  const { page, complaints } = await openPage(browser, { viewport: { width: 1280, height: 900 } });
  const body = JSON.stringify({ ...STUDY, layouts: { spacings_deg: [60, 30], positions: ["crown"] } });
  const answer = await fetch(`${service.url}/v1/studies`, { method: "POST", headers: { "Content-Type": "application/json" }, body });
  const { id } = await answer.json();
  await page.route(/\/v1\/studies\/[^/]+\/result$/, async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, json: response.ok() ? earlier(await response.json()) : await response.json() });
  });
  await page.goto(`${service.url}/#/studies/${id}`);
  const rows = page.getByRole("table", { name: "Ranked layouts" }).locator("tbody tr");
  await rows.first().waitFor({ timeout: 50_000 });
  assert.equal(await rows.count(), 2);
  assert.match(await rows.first().innerText(), /^1\s+(30|60)\s+(12|6)\s+crown\s+x, y\s+[\d.]+/);
  assert.equal(await page.locator("svg.layout-plot").count(), 0);
  assert.deepEqual(complaints, []);
});

/** A result without what it didn't have before layouts were simulated. */
function earlier({ layout_findings: _, ...result }) {
  const layouts = result.layouts.map(({ rank, spacing_deg, units, position, films, score }) => {
    const { weakest_signal, worst_angle_error_deg, rms_angle_error_deg, worst_depth_error_mm, noise_strain } = score;
    return { rank, spacing_deg, units, position, films, score: { weakest_signal, worst_angle_error_deg, rms_angle_error_deg, worst_depth_error_mm, noise_strain } };
  });
  return { ...result, layouts };
}
