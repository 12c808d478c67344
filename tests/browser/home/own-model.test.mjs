// Indices of a model of the reader's own: points to run, faults at their place, bars with errors.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { openBrowser, openPage, overlaps, setting, violations } from "../page.mjs";
import { startService } from "../service.mjs";

const WINDOWS = [
  { width: 1280, height: 900 },
  { width: 390, height: 844 },
];
const INPUTS = ["force_n", "height_mm"].map((name) => `[[inputs]]\nname = "${name}"\ndistribution = { kind = "uniform", min = 1, max = 2 }\n`).join("");

let service;
let browser;
let page;
let complaints;

before(async () => {
  service = await startService();
  browser = await openBrowser();
  ({ page, complaints } = await openPage(browser, { viewport: WINDOWS[0], acceptDownloads: true }));
});

after(async () => {
  await browser?.close();
  await service?.stop();
});

const drop = (place, name, text) =>
  page
    .locator('input[type="file"]')
    .nth(place)
    .setInputFiles({ name, mimeType: "text/plain", buffer: Buffer.from(text) });

async function hold() {
  for (const viewport of WINDOWS) {
    await page.setViewportSize(viewport);
    for (const colorScheme of ["light", "dark"]) {
      await page.emulateMedia({ colorScheme });
      assert.deepEqual(await violations(page), [], `${viewport.width} px, ${colorScheme}`);
    }
    assert.deepEqual(await overlaps(page), [], "texts on each other");
    const { small, overflow } = await setting(page, 1e9);
    assert.deepEqual(small, [], "texts below 11 px");
    assert.ok(overflow <= 0, `the page is ${overflow} px wider than its window`);
  }
  await page.setViewportSize(WINDOWS[0]);
  await page.emulateMedia({ colorScheme: "light" });
}

test("inputs give points to run, and values at these points give bars with errors", async () => {
  await page.goto(service.url);
  await page.getByRole("link", { name: "Your model" }).click();
  await drop(0, "inputs.toml", INPUTS.replace("max = 2", "max = 0"));
  await page.getByText("/inputs/0/distribution").waitFor();
  await drop(0, "inputs.toml", INPUTS);
  await page.getByText("points are to be run first").waitFor();
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Save the points to run as CSV" }).click()]);
  const [head, ...rows] = (await readFile(await download.path(), "utf8")).trim().split("\n");
  assert.equal(head, "id,force_n,height_mm");
  const values = rows.map((row) => row.split(",").map(Number)).map(([id, force, height]) => `${id},${(force / height ** 2).toExponential(16)}`);
  await drop(1, "values.csv", ["id,strain", ...values].join("\n"));
  const chart = page.getByRole("img", { name: /First-order indices of strain, percent: height_mm 79\.\d ± \d\.\d, force_n 17\.\d ± \d\.\d$/ });
  await chart.waitFor();
  await hold();
  // The faulty file was refused.
  assert.deepEqual(
    complaints.filter((text) => !/status of 422 .*\/v1\/analyses$/.test(text)),
    [],
  );
});
