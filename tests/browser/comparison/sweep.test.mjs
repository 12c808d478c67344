// A sweep from its grid to what differs between its designs, as a user does it in a browser.
import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { openBrowser, openPage, showText } from "../page.mjs";
import { startService } from "../service.mjs";

const SCREENSHOTS = fileURLToPath(new URL("../screenshots/", import.meta.url));
// Seconds on two quiet cores; shared ones get forty times that.
const SWEEP_MS = Number(process.env.STRAINSITE_STUDY_MS ?? 600_000);
const WIDE = { viewport: { width: 1280, height: 900 } };

let service;
let browser;

before(async () => {
  mkdirSync(SCREENSHOTS, { recursive: true });
  service = await startService();
  browser = await openBrowser();
});

after(async () => {
  await browser?.close();
  const end = await service?.stop();
  assert.deepEqual(end, { code: 0, signal: null }, service?.log());
});

// The preset's own take several times as long as all the rest.
const LAYOUTS = { spacings_deg: [60, 90], positions: ["crown"], depths_mm: [1] };

/** Opens the page with the first preset on this mesh, with three nodes an input and few layouts, and writes a grid. */
async function writeSweep(page, accuracy, grid, name = "") {
  await page.goto(service.url);
  await page.locator('.preset input[value="foot-tire"]').check();
  const text = await showText(page);
  const document = JSON.parse(await text.inputValue());
  await text.fill(JSON.stringify({ ...document, layouts: LAYOUTS, method: { kind: "mdrm", nodes: 3 } }, null, 2));
  await page.getByLabel("Accuracy").selectOption(accuracy);
  await page.getByLabel("Name, the study's when empty").fill(name);
  await page.getByLabel("What varies").fill(grid);
}

async function runSweep(page, designs) {
  await page.getByRole("button", { name: "Check and estimate" }).click();
  await page.getByRole("button", { name: `Run ${designs} designs` }).click();
  await page.waitForURL(/#\/sweeps\//);
}

/** Texts of the cells of a table, row by row. */
function cells(page, label) {
  return page
    .getByRole("table", { name: label })
    .locator("tbody tr")
    .evaluateAll((rows) => rows.map((row) => [...row.cells].map((cell) => cell.innerText.trim())));
}

test("a wrong grid is refused with every fault at its place", async () => {
  const { page, complaints } = await openPage(browser, WIDE);
  const grid = "geometry.wall_mm = 2.5, -1\ngeometry.wal_mm = 1";
  await writeSweep(page, "draft", grid);
  await page.getByRole("button", { name: "Check and estimate" }).click();
  const faults = page.locator("#sweep-faults .fault-list li");
  await faults.first().waitFor();
  assert.equal(await faults.count(), 2, (await faults.allInnerTexts()).join(" | "));
  await page.locator(".place").filter({ hasText: "/grid/geometry.wall_mm/1" }).click();
  const selected = await page.getByLabel("What varies").evaluate((area) => area.value.slice(area.selectionStart, area.selectionEnd));
  assert.equal(selected, "-1");
  assert.equal(await page.getByRole("button", { name: /^Run \d+ designs$/ }).count(), 0, "what isn't estimated can't be run");

  // Lines that can't be read are told by the page itself, and so are faults of the study, in its own text.
  await page.getByLabel("What varies").fill("wall 3\ngeometry.wall_mm = 3,");
  await page.getByRole("button", { name: "Check and estimate" }).click();
  await page.locator(".place").filter({ hasText: "#2" }).waitFor();
  await page.getByLabel("What varies").fill("geometry.wall_mm = 3");
  const study = page.getByLabel("Study document (JSON)");
  await study.fill((await study.inputValue()).replace('"name": "', '"nam": "'));
  await page.getByRole("button", { name: "Check and estimate" }).click();
  await page.locator("#sweep-faults .place").filter({ hasText: "/study" }).first().click();
  assert.ok(await study.evaluate((area) => document.activeElement === area && area.selectionEnd > area.selectionStart));
  const others = complaints.filter((text) => !/status of 422 .*\/v1\/(sweeps:estimate|studies:estimate|studies:preview)$/.test(text));
  assert.deepEqual(others, []);
  await page.context().close();
});

test("a sweep runs from its grid to what differs between its designs", { timeout: SWEEP_MS }, async (t) => {
  const { page, requests, complaints } = await openPage(browser, WIDE);
  await writeSweep(page, "coarse", "carcass.angle_deg = 50, 60", "cord");
  await runSweep(page, 2);
  await page.getByRole("heading", { name: "cord", level: 1 }).waitFor();
  await page.locator(".study-head .badge-done").waitFor({ timeout: SWEEP_MS });
  const entry = page.locator(".sweep-list a");
  // The list asks for itself, a little later than the page.
  await entry.filter({ hasText: "2/2 designs" }).waitFor();
  assert.match(await entry.innerText(), /cord/);
  await page.getByRole("heading", { name: "What differs" }).waitFor();

  const designs = await cells(page, "Designs");
  t.diagnostic(designs.map((row) => row.join(" ")).join(" | "));
  assert.deepEqual(
    designs.map((row) => row.slice(0, 3)),
    [
      ["1", "angle_deg = 50", "done"],
      ["2", "angle_deg = 60", "done"],
    ],
  );
  for (const row of designs) {
    assert.match(row[3], /^\d+\.\d\d$/, "the force");
    assert.match(row[6], /^P\d (un)?certain$/);
  }
  const answers = await cells(page, "Answers of the studies");
  assert.deepEqual(
    answers.map((row) => row[0]),
    ["1", "2"],
  );
  for (const row of answers) assert.match(row[2], /^\d+ films along/, "the layout");
  const listed = await page.evaluate(() => fetch(`/v1/comparison?sweep=${location.hash.split("/")[2]}`).then((answer) => answer.json()));
  const x = await cells(page, "Index and difference, strain x, circumferential");
  const row = listed.rows.find(({ study, location }) => study === listed.studies[1].id && location === "P3").x;
  const minus = (text) => text.replace("-", "−");
  const sign = row.difference_percent < 0 ? "" : "+";
  const expected = `${row.gsi_percent.toFixed(2)} ± ${row.error_percent.toFixed(2)} ${sign}${row.difference_percent.toFixed(2)} ± ${row.difference_error_percent.toFixed(2)}`;
  assert.ok(x[1][4].replace(/[★\s]+/g, " ").startsWith(minus(expected)), `${x[1][4]} is ${expected}`);
  const real = listed.rows.filter((entry) => entry.x.verdict === "real").length;
  assert.equal(x.flat().filter((text) => text.includes("★")).length, real, "a star for each real difference");
  assert.equal(await page.locator(".comparison-chart").first().locator(".mark-real").count(), real, "and a mark in the chart");
  await page.screenshot({ path: `${SCREENSHOTS}sweep.png`, fullPage: true });

  // Another baseline, and differences in place of indices: both in the address.
  await page.getByLabel("Differences from").selectOption({ label: "2: angle_deg = 60" });
  await page.waitForURL(/baseline=/);
  await page.locator("tr.baseline th").first().filter({ hasText: "angle_deg = 60" }).waitFor();
  await page.locator('input[name="shown"][value="difference"]').check({ force: true });
  await page.waitForURL(/shown=difference/);
  await page.reload();
  await page.locator("tr.baseline th").first().filter({ hasText: "angle_deg = 60" }).waitFor();
  const turned = await cells(page, "Index and difference, strain x, circumferential");
  assert.match(turned[0][4], new RegExp(`${sign === "" ? "\\+" : "−"}${Math.abs(row.difference_percent).toFixed(2)}`), "the difference is turned round");
  assert.ok(await page.locator('input[name="shown"][value="difference"]').isChecked());

  await page.setViewportSize({ width: 400, height: 800 });
  // Drawings follow the window in the next frame.
  await page.waitForFunction(() => document.documentElement.scrollWidth <= window.innerWidth);
  await page.screenshot({ path: `${SCREENSHOTS}sweep-narrow.png`, fullPage: true });

  // To a design's study and back to the sweep.
  await page.getByRole("table", { name: "Designs" }).getByRole("link", { name: "angle_deg = 50" }).click();
  await page.getByRole("link", { name: "Indices", exact: true }).click();
  await page.locator("table.ranking").waitFor();
  await page.getByRole("link", { name: "a sweep" }).click();
  await page.getByRole("heading", { name: "cord", level: 1 }).waitFor();
  assert.ok(
    requests.every((url) => new URL(url).origin === service.url),
    requests.join(" "),
  );
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("a sweep is cancelled and resumed from the page, and a design that fails says why", { timeout: SWEEP_MS }, async () => {
  const { page, complaints } = await openPage(browser, WIDE);
  // With next to no textile the tire has its limit point below its pressure.
  await writeSweep(page, "draft", "carcass.stiffness_n_per_mm = 1, 50, 100");
  await runSweep(page, 3);
  await page.getByRole("button", { name: "Cancel sweep" }).click();
  await page.locator(".study-head .badge-cancelled").waitFor();
  await page.getByRole("button", { name: /^Resume [123] designs?$/ }).click();
  await page.locator(".study-head .badge-done").waitFor({ timeout: SWEEP_MS });
  assert.match(await page.getByRole("region", { name: "Progress" }).innerText(), /2 of 3 designs have a result/);
  await page.getByRole("heading", { name: "What differs" }).waitFor();
  const [failed, solved] = await cells(page, "Designs");
  assert.equal(failed[2], "failed");
  assert.match(failed[3], /limit-point/);
  assert.match(solved[3], /^\d+\.\d\d$/, "the force");
  assert.equal(await page.getByRole("button", { name: "Resume 1 design" }).count(), 1);
  assert.match(await page.locator(".notes").innerText(), /Of a draft no error is known/i);
  assert.deepEqual(complaints, []);
  await page.context().close();
});
