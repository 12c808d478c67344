// A study from the preset to its ranking, as a user does it in a browser.
import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { openBrowser, openPage, readCanvas, showText } from "./page.mjs";
import { startService } from "./service.mjs";

const SCREENSHOTS = fileURLToPath(new URL("screenshots/", import.meta.url));
// A study takes seconds on two quiet cores; shared ones get all the time that they may need.
const STUDY_MS = Number(process.env.STRAINSITE_STUDY_MS ?? 600_000);
const PAPER_X = { P1: "1.47", P2: "6.11", P3: "29.97", P4: "6.67", P5: "1.58" };

let service;
let browser;

before(async () => {
  mkdirSync(SCREENSHOTS, { recursive: true });
  service = await startService();
  browser = await openBrowser();
});

after(async () => {
  await browser?.close();
  // The last test has stopped it, unless it was left out by a pattern of names: then the file would never end.
  await service?.stop();
});

/** Writes few layouts into the chosen preset, at one depth: the preset's own take four times as long as all the rest, and have a test of their own. */
async function askForFewLayouts(page) {
  const text = await showText(page);
  const document = JSON.parse(await text.inputValue());
  const layouts = { spacings_deg: [60, 90], positions: ["crown"], depths_mm: [1] };
  await text.fill(JSON.stringify({ ...document, layouts }, null, 2));
}

/** Opens the page and chooses the first preset, the depths of 1 mm and 30 percent about it. */
async function choosePreset(page) {
  await page.goto(service.url);
  await page.getByRole("heading", { name: "New study" }).waitFor();
  const presets = page.locator(".preset");
  await presets.first().waitFor();
  assert.ok((await presets.count()) >= 2, "both studies of the paper are offered");
  await page.locator('.preset input[value="foot-tire"]').check();
  const text = await (await showText(page)).inputValue();
  assert.equal(JSON.parse(text).inputs.length, 5);
  return text;
}

/** Texts of a study's row in the ranked table. */
async function rankedRows(page) {
  return page.$$eval("table.ranking tbody tr", (rows) =>
    rows.map((row) => ({
      name: row.dataset.location,
      cells: [...row.cells].map((cell) => cell.textContent.trim()),
    })),
  );
}

test("a wrong document is refused with every fault at its place", async () => {
  const { page, requests, complaints } = await openPage(browser, { viewport: { width: 1280, height: 900 } });
  const document = JSON.parse(await choosePreset(page));
  document.inputs[1].distribution = { kind: "uniform", min: 2, max: 1 };
  document.method.nodes = -3;
  await page.getByLabel("Study document (JSON)").fill(JSON.stringify(document, null, 2));
  await page.getByRole("button", { name: "Run study" }).click();
  const faults = page.locator(".fault-list li");
  await faults.first().waitFor();
  const texts = await faults.allTextContents();
  assert.ok(
    texts.some((text) => text.includes("/inputs/1/distribution")),
    texts.join(" | "),
  );
  assert.ok(
    texts.some((text) => text.includes("/method")),
    texts.join(" | "),
  );
  const place = page.locator(".place").filter({ hasText: "/inputs/1/distribution" }).first();
  await place.click();
  const selected = await page.getByLabel("Study document (JSON)").evaluate((area) => area.value.slice(area.selectionStart, area.selectionEnd));
  assert.ok(selected.length > 0 && JSON.stringify(document, null, 2).includes(selected));
  await page.screenshot({ path: `${SCREENSHOTS}faults.png`, fullPage: true });
  assert.ok(
    requests.every((url) => new URL(url).origin === service.url),
    requests.join(" "),
  );
  // The browser itself writes refusals to its console, of the study and of what is asked while it is written; nothing else may stand there.
  const others = complaints.filter((text) => !/status of 4(00|22) .*\/v1\/studies(:estimate|:preview)?$/.test(text));
  assert.deepEqual(others, []);
  await page.context().close();
});

test("a study runs from the preset to the ranking and its map", { timeout: STUDY_MS + 60_000 }, async (t) => {
  const { page, requests, complaints } = await openPage(browser, { viewport: { width: 1280, height: 900 } });
  await choosePreset(page);
  await askForFewLayouts(page);
  // Seconds at the standard level, long enough for the progress to be seen.
  for (const preset of ["reference", "standard"]) {
    await page.getByLabel("Accuracy").selectOption(preset);
    const written = JSON.parse(await page.getByLabel("Study document (JSON)").inputValue());
    assert.deepEqual(written.accuracy, { preset });
  }

  await page.getByRole("button", { name: "Run study" }).click();
  await page.waitForURL(/#\/studies\//);
  const study = page.url();
  const bar = page.getByRole("progressbar", { name: "Points solved" });
  await bar.waitFor();
  const shares = new Set();
  const answer = page.locator(".answer-sentence");
  const deadline = Date.now() + STUDY_MS;
  while (!(await answer.isVisible())) {
    assert.ok(Date.now() < deadline, `no answer after ${STUDY_MS} ms; the service says ${service.log()}`);
    assert.equal(await page.locator(".badge-failed").count(), 0, await page.locator("main").innerText());
    if (await bar.isVisible()) shares.add(await bar.evaluate((element) => element.value).catch(() => 0));
    await page.waitForTimeout(20);
  }
  assert.ok(shares.size >= 3, `progress was seen at ${[...shares].join(", ")}`);
  t.diagnostic(`progress was seen at ${shares.size} values`);

  await page.screenshot({ path: `${SCREENSHOTS}study.png`, fullPage: true });
  await page.getByRole("link", { name: "Indices", exact: true }).click();
  const ranking = page.locator("table.ranking");
  await page.getByRole("checkbox", { name: /Compare with the paper/ }).check();
  const rows = await rankedRows(page);
  t.diagnostic(rows.map((row) => row.cells.join(" ")).join(" | "));
  assert.deepEqual(rows.map((row) => row.name).toSorted(), Object.keys(PAPER_X));
  assert.equal(rows[0].name, "P3", "the centre ranks first");
  assert.equal(rows[0].cells[0], "1");
  for (const row of rows) assert.ok(row.cells.includes(PAPER_X[row.name]), `${row.name}: ${row.cells.join(" ")}`);
  assert.match(rows[0].cells[3], /^\d+\.\d\d ± (\d+\.\d\d|\?)$/, "an index stands with its error");

  await page.getByRole("link", { name: "Run", exact: true }).click();
  const compared = await page.locator("table.estimate").innerText();
  assert.match(compared, /Wall time.* s.*Peak memory.*[MG]B/s, "what was expected stands beside what it took");

  const links = await page.$$eval("p.provenance a", (anchors) => anchors.map((anchor) => anchor.href));
  for (const part of ["format=csv", "format=parquet", "format=vtu"])
    assert.ok(
      links.some((link) => link.includes(part)),
      links.join(" "),
    );
  const lengths = await page.evaluate(
    (addresses) =>
      Promise.all(
        addresses.map(async (address) => {
          const answer = await fetch(address);
          return answer.ok ? (await answer.blob()).size : 0;
        }),
      ),
    links,
  );
  assert.ok(
    lengths.every((length) => length > 0),
    `every link gives a file: ${lengths.join(" ")}`,
  );

  await page.getByRole("link", { name: "Tire", exact: true }).click();
  await page.locator(".map canvas").waitFor();
  const drawn = await readCanvas(page);
  // A blank canvas has one colour at most; a field of 61 by 21 cells has dozens.
  assert.ok(drawn.colours > 20, `the map shows ${drawn.colours} colours`);

  await page.locator('input[name="map-direction"][value="y"]').check({ force: true });
  await page.waitForURL(/direction=y/);
  await page.waitForFunction(() => document.querySelector(".legend figcaption")?.textContent.includes("meridional"));
  await page.waitForTimeout(200);
  const turned = await readCanvas(page);
  assert.notEqual(turned.hash, drawn.hash, "the other direction draws another map");

  await page.locator(".map").focus();
  await page.keyboard.press("ArrowUp");
  await page.locator(".readout strong").waitFor();
  assert.match(await page.locator(".reading").innerText(), /θ .*φ .*(%|µε)/s);

  await page.reload();
  await page.locator(".map canvas").waitFor();
  assert.ok(await page.locator('input[name="map-direction"][value="y"]').isChecked(), "the address keeps the view");
  // Links from before the sections opened one long page.
  await page.goto(`${study}?direction=y&quantity=std`);
  await page.locator(".map canvas").waitFor();
  await page.goto(`${study}/indices`);
  await ranking.waitFor();

  await page.setViewportSize({ width: 400, height: 800 });
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
  assert.ok(overflow <= 0, `the narrow page is ${overflow} px too wide`);
  await page.screenshot({ path: `${SCREENSHOTS}study-narrow.png`, fullPage: true });

  assert.ok(
    requests.every((url) => new URL(url).origin === service.url),
    requests.join(" "),
  );
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("a running study is cancelled from the page", { timeout: STUDY_MS }, async () => {
  const { page, complaints } = await openPage(browser, { viewport: { width: 1280, height: 900 } });
  const document = JSON.parse(await choosePreset(page));
  document.name = "one to cancel";
  // Of no point that an earlier study has solved, and seconds long.
  document.accuracy = { preset: "reference" };
  await page.getByLabel("Study document (JSON)").fill(JSON.stringify(document, null, 2));
  await page.getByRole("button", { name: "Run study" }).click();
  await page.getByRole("button", { name: "Cancel study" }).click();
  await page.locator(".study-head .badge-cancelled").waitFor();
  assert.equal(await page.getByRole("button", { name: "Cancel study" }).count(), 0);
  const again = await page.getByRole("link", { name: "Run again with changes" }).getAttribute("href");
  assert.match(again, /^#\/\?again=[0-9a-f-]{36}$/);
  await page.getByText("The document as the service reads it").click();
  assert.match(await page.locator(".document-text").innerText(), /one to cancel/);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("a study is removed from the list, and for good once the page is left", { timeout: STUDY_MS }, async () => {
  const { page, complaints } = await openPage(browser, { viewport: { width: 1280, height: 900 } });
  await page.goto(service.url);
  const entries = page.locator(".study-list li");
  await entries.first().waitFor();
  const before = await entries.count();
  await entries
    .first()
    .getByRole("button", { name: /^More for/ })
    .click();
  await entries.first().locator(".entry-remove").click();
  await page.waitForFunction((left) => document.querySelectorAll(".study-list li").length === left, before - 1);
  const stored = async () => (await (await fetch(`${service.url}/v1/studies`)).json()).studies.length;
  assert.equal(await stored(), before, "until the page is left it can be taken back");
  await page.goto("about:blank");
  const deadline = Date.now() + 10_000;
  while ((await stored()) !== before - 1) assert.ok(Date.now() < deadline, "it is still stored");
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("a browser is let in by the printed address, once, and follows a study by its cookie, below a path", { timeout: STUDY_MS }, async (t) => {
  const locked = await startService("--token", "--base-path", "/site");
  t.after(() => locked.stop());
  const { page, complaints } = await openPage(browser, { viewport: { width: 1280, height: 900 } });
  const printed = () => /in a browser, once: (\S+)/.exec(locked.printed())?.[1];
  while (printed() === undefined) await page.waitForTimeout(20);
  const link = printed();
  await page.goto(link);
  assert.equal(page.url(), `${locked.url}/site/`, "the address that worked once is left behind");
  await page.locator('.preset input[value="foot-tire"]').check();
  await askForFewLayouts(page);
  await page.getByLabel("Accuracy").selectOption("draft");
  await page.getByRole("button", { name: "Run study" }).click();
  await page.locator(".answer-sentence").waitFor({ timeout: STUDY_MS });
  assert.deepEqual(complaints, []);
  await page.context().close();

  const { page: stranger } = await openPage(browser, { viewport: { width: 1280, height: 900 } });
  for (const address of [link, locked.url]) assert.equal((await stranger.goto(address))?.status(), 401);
  await stranger.context().close();
  assert.deepEqual(await locked.stop(), { code: 0, signal: null }, locked.log());
});

test("the service ends cleanly when it is interrupted", async () => {
  await browser.close();
  const end = await service.stop();
  assert.deepEqual(end, { code: 0, signal: null }, service.log());
});
