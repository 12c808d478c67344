// Forces learnt from dropped recordings: what is refused, the answer, the splits, the rows that were left out, another recording, and removal.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { openBrowser, openPage, overlaps, savedTexts, setting, violations } from "../page.mjs";
import { startService } from "../service.mjs";

const WINDOWS = [
  { width: 1280, height: 900 },
  { width: 390, height: 844 },
];
const FIT_MS = Number(process.env.STRAINSITE_STUDY_MS ?? 600_000);
/** A second's work. */
const RECIPE = '[models]\nkinds = ["ridge", "gpr"]\ngpr = { restarts = 1, search_rows = 60, most_rows = 100 }\n\n[features]\nsets = ["raw"]\n';

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

/** Ten presses that two of three signals know, and a force that none of them does. */
function recording(name, seed, isMeasured = true) {
  let state = seed;
  // Park and Miller's.
  const random = () => {
    state = (state * 48_271) % 2_147_483_647;
    return state / 2_147_483_647 - 0.5;
  };
  const heights = Array.from({ length: 10 }, () => 12 + 14 * random());
  const rows = Array.from({ length: 150 }, (_, k) => {
    const fz = Math.max(Math.sin((2 * Math.PI * k) / 15), 0) * heights[Math.floor(k / 15)];
    const signals = [2 * fz + random() / 2, -fz + random() / 2, random()];
    return [k / 10, ...signals, ...(isMeasured ? [random(), fz] : [])].join(",");
  });
  const head = `time_s,s1,s2,s3${isMeasured ? ",fx_n,fz_n" : ""}`;
  return { name, mimeType: "text/csv", buffer: Buffer.from(`${[head, ...rows].join("\n")}\n`) };
}

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

/** The text of what a press lets the browser save. */
async function saved(press) {
  const [download] = await Promise.all([page.waitForEvent("download"), press()]);
  return { name: download.suggestedFilename(), text: await readFile(await download.path(), "utf8") };
}

test("nothing was learnt yet, and a faulty recipe is refused at its place", async () => {
  await page.goto(service.url);
  await page.getByRole("link", { name: "Forces" }).click();
  await page.getByText("Nothing was learnt yet.").waitFor();
  await hold();
  assert.ok(await page.getByRole("button", { name: "Learn forces" }).isDisabled());
  await page.locator('.fit-form input[type="file"]').setInputFiles([recording("tuesday.csv", 2), recording("monday.csv", 1), recording("sunday.csv", 3)]);
  await page.getByText("150 rows").first().waitFor();
  await page.getByRole("button", { name: "Leave sunday.csv out" }).click();
  // As a logger of Latin-1 writes it.
  const german = Buffer.from("# Prüfstand\nZeit;s1_µV\n0;1\n1;2\n", "latin1");
  await page.locator('.fit-form input[type="file"]').setInputFiles({ name: "german.csv", mimeType: "text/csv", buffer: german });
  await page.getByText("2 rows, 31 B; Zeit, s1_µV").waitFor();
  await page.getByRole("button", { name: "Leave german.csv out" }).click();
  assert.deepEqual(await page.locator(".file-list li > span").evaluateAll((all) => all.map((each) => each.firstChild.textContent)), [
    "monday.csv",
    "tuesday.csv",
  ]);
  await page.getByText("Recipe:").click();
  await page.getByLabel("TOML or JSON").fill("[models");
  await page.getByRole("button", { name: "Learn forces from 2 runs" }).click();
  await page.getByText("This is not TOML yet. Line 1").waitFor();
  await page.getByLabel("TOML or JSON").fill('models = { kinds = ["tree"] }');
  await page.getByRole("button", { name: "Learn forces from 2 runs" }).click();
  await page.locator("#fit-faults code").filter({ hasText: "/recipe/models/kinds" }).waitFor();
  await hold();
  const others = complaints.splice(0).filter((text) => !/status of 422 .*\/v1\/estimators$/.test(text));
  assert.deepEqual(others, []);
});

test("the columns are looked at before anything is learnt", async () => {
  await page.getByLabel("TOML or JSON").fill(RECIPE);
  const broken = { name: "broken.csv", mimeType: "text/csv", buffer: Buffer.from("time_s,s1,s2,s3,fx_n,fz_n\n0,1,x,2,3,4\n") };
  const marred = recording("marred.csv", 5);
  const rows = marred.buffer.toString().split("\n");
  rows[70] = rows[70].replace(/^([^,]*),[^,]*/, "$1,900");
  await page.locator('.fit-form input[type="file"]').setInputFiles([broken, { ...marred, buffer: Buffer.from(rows.join("\n")) }]);
  await page.getByText("marred.csv").first().waitFor();
  await page.getByRole("button", { name: "Look at the columns" }).click();
  await page.getByText("Not every recording can be read.").waitFor();
  assert.match(await page.locator(".look > .problem").innerText(), /broken\.csv, line 2, column s2/);
  const table = page.getByRole("table", { name: "Columns of marred.csv" });
  assert.deepEqual(await table.locator("tbody tr > :nth-child(2)").allInnerTexts(), ["time, s", "signal suspect", "signal", "signal", "force, N", "force, N"]);
  await page.getByRole("img", { name: /^s1 over time, .*samples that stand alone: 1$/ }).waitFor();
  assert.match(await page.locator(".look details .notes").innerText(), /marred\.csv, line 71, column s1: 900 stands alone/);
  await hold();
  // An edit takes away what was looked at before.
  for (const file of ["broken.csv", "marred.csv"]) await page.getByRole("button", { name: `Leave ${file} out` }).click();
  assert.equal(await page.locator(".look").count(), 0);
  assert.deepEqual(complaints.splice(0), []);
});

test("two runs are learnt from: answer, splits, rows left out, and another recording", { timeout: FIT_MS }, async (t) => {
  await page.getByLabel("TOML or JSON").fill(RECIPE);
  await page.getByLabel("Name, the first").fill("rig");
  await page.getByRole("button", { name: "Learn forces from 2 runs" }).click();
  await page.waitForURL(/#\/forces\/[^/]+$/);
  await page.locator(".force-answer").first().waitFor({ timeout: FIT_MS });
  const address = `${service.url}/v1/estimators/${page.url().split("/").at(-1)}`;
  const report = await (await fetch(`${address}/report`)).json();
  assert.deepEqual(
    report.forces.map(({ force }) => force),
    ["fx_n", "fz_n"],
  );

  const sentence = (force) => page.locator(`[data-force="${force}"] .force-sentence`).innerText();
  assert.match(await sentence("fx_n"), /^Useless: no model knows it 5 % better than the training mean/);
  const [known] = report.forces[1].models;
  t.diagnostic(await sentence("fz_n"));
  assert.equal(
    await sentence("fz_n"),
    `Off by ${digits(known.validation.rmse_n)} N (${known.validation.rmse_interval_n.map(digits).join(" to ")}) on runs that it didn't learn from.`,
  );

  await page.locator('label:has(input[name="force"][value="fz_n"])').click();
  await page.waitForURL(/force=fz_n/);
  const cells = await page.locator("table.splits .chosen-row td").allInnerTexts();
  assert.deepEqual(
    [cells[1], cells[3]],
    [known.splits.random.rmse_n, known.splits.run.rmse_n].map((error) => error.toFixed(3)),
  );
  assert.equal(Number(cells.at(-1)), Number(known.leak_factor.toFixed(2)));

  const plots = page.locator('svg[aria-label^="fz_n of "]');
  assert.equal(await plots.count(), 2);
  for (const line of ["band", "truth-line", "estimate-line"])
    assert.ok((await plots.first().locator(`.${line}`).getAttribute("d")).split("L").length > 149, line);
  const drawn = await plots.first().evaluate((plot) => /^Save (.*) as SVG$/.exec(plot.closest("figure").querySelector("button").ariaLabel)[1]);
  assert.match(await savedTexts(page, drawn), /^rig: fz_n .*measured estimated 95 % interval$/);
  const left = await saved(() => page.getByRole("button", { name: "Save rows that were left out as CSV" }).click());
  assert.equal(left.text.trim().split("\n").length, 1 + 2 * 300);

  const friday = recording("friday.csv", 4, false);
  await page.locator('.applied input[type="file"]').setInputFiles(friday);
  const forces = await saved(() => page.getByRole("button", { name: "Save forces as CSV" }).click());
  const body = JSON.stringify({ file: "friday.csv", text: friday.buffer.toString() });
  const answer = await fetch(`${address}:apply`, { method: "POST", headers: { "Content-Type": "application/json" }, body });
  assert.equal(forces.text, await answer.text());
  assert.equal(forces.name, "friday-forces.csv");
  await page.locator('svg[aria-label*="friday.csv over time"]').nth(1).waitFor();
  await hold();
  assert.deepEqual(complaints.splice(0), []);

  await page.locator('.applied input[type="file"]').setInputFiles({ ...friday, buffer: Buffer.from("time_s,s1\n0,1\n") });
  await page.locator(".applied .problem").waitFor();
  assert.match(await page.locator(".applied .problem").innerText(), /s2/);
  const others = complaints.splice(0).filter((text) => !/status of 422 /.test(text));
  assert.deepEqual(others, []);
});

test("a fit that is at work, waits, failed or was cancelled says so, one that isn't there too", async () => {
  const url = page.url();
  const detail = new RegExp(`/v1/estimators/${url.split("/").at(-1).split("?")[0]}$`);
  const states = [
    [{ state: "running", progress: { stage: "judging", done: 3, of: 6 } }, "3 of 6 models judged"],
    [{ state: "queued", started: null, finished: null }, "Waiting for its turn."],
    [{ state: "failed", error: "every row is an outlier" }, "Every row is an outlier"],
    [{ state: "cancelled" }, "Cancelled: nothing was learnt."],
  ];
  for (const [change, words] of states) {
    await page.route(detail, async (route) => {
      const answer = await route.fetch();
      await route.fulfill({ response: answer, json: { ...(await answer.json()), ...change } });
    });
    await page.goto("about:blank");
    await page.goto(url);
    await page.getByText(words).waitFor();
    await hold();
    // The page may be asking: its answer is on the way.
    await page.unrouteAll({ behavior: "wait" });
  }
  assert.deepEqual(complaints.splice(0), []);
  await page.goto(`${service.url}/#/forces/nowhere`);
  await page.getByRole("alert").filter({ hasText: "nowhere" }).waitFor();
  await hold();
  const others = complaints.splice(0).filter((text) => !/status of 404 /.test(text));
  assert.deepEqual(others, []);
});

test("the list leads to an estimator, and one that is removed is gone", async () => {
  await page.goto(`${service.url}/#/forces`);
  await page.getByRole("link", { name: "rig", exact: true }).click();
  await page.locator(".force-answer").first().waitFor();
  page.once("dialog", (dialog) => void dialog.accept());
  await page.getByRole("button", { name: "Remove estimator" }).click();
  await page.getByText("Nothing was learnt yet.").waitFor();
  assert.deepEqual(complaints.splice(0), []);
});

/** Three digits, as the page has them. */
function digits(value) {
  return value.toFixed(Math.max(0, 2 - Math.floor(Math.log10(Math.abs(value)))));
}
