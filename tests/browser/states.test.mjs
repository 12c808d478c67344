// What isn't a finished study: an empty database, sweeps, comparisons, studies that failed, were cancelled, run or lost their service. And what keys alone do.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { openBrowser, openPage, overlaps, setting, violations } from "./page.mjs";
import { startService } from "./service.mjs";

const WINDOWS = [
  { width: 1440, height: 900 },
  { width: 390, height: 844 },
];
const STUDY_MS = Number(process.env.STRAINSITE_STUDY_MS ?? 600_000);
/** Tabs from the start of the page to the map, the skip link among them. */
const TABS = 8;
const depth = (station) => ({ name: `P${station + 1}`, vary: `ground.depths_mm[${station}]`, distribution: { kind: "uniform", min: 0.7, max: 1.3 } });
const STUDY = {
  name: "textile",
  scene: { preset: "foot-tire" },
  inputs: [0, 1, 2, 3, 4].map(depth),
  candidates: { points: "P1-P5", grid: { circumferential: 21, meridional: 9 } },
  layouts: { spacings_deg: [60, 90], positions: ["crown"], depths_mm: [1] },
  method: { kind: "mdrm", nodes: 3 },
  accuracy: { preset: "draft" },
};
/** Of no point that another study has solved, and seconds long. */
const LONG = { ...STUDY, name: "seconds long", method: { kind: "mdrm", nodes: 5 }, accuracy: { preset: "standard" } };

let service;
let browser;
let page;
let complaints;
let cancelled;

before(async () => {
  service = await startService();
  browser = await openBrowser();
  ({ page, complaints } = await openPage(browser, { viewport: WINDOWS[0] }));
});

after(async () => {
  await browser?.close();
  await service?.stop();
});

async function sent(path, document) {
  const answer = await fetch(`${service.url}/v1${path}`, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(document) });
  assert.equal(answer.status, 202, await answer.clone().text());
  return (await answer.json()).id;
}

/** All rules of accessibility and of sizes, at both widths in both colours, without loading the page anew. */
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
  assert.deepEqual(complaints.splice(0), []);
}

test("an empty database says so beside the form", async () => {
  await page.goto(service.url);
  await page.getByText("No study yet").waitFor();
  await page.locator(".preview-force").waitFor();
  await hold();
});

test("what isn't there is told by the page and its title, with ways on", async () => {
  for (const [address, title, words] of [
    ["nowhere", "Page not found", "#/nowhere names no page"],
    ["studies/none", "Study not found", 'There is no study "none"'],
    ["sweeps/none", "Sweep not found", 'There is no sweep "none"'],
    ["forces/none", "Estimator not found", 'There is no estimator "none"'],
    ["compare?studies=none,neither", "Comparison of 2 studies", "There is no study"],
  ]) {
    await page.goto(`${service.url}/#/${address}`);
    await page.getByRole("alert").filter({ hasText: words }).waitFor();
    // The title follows once the page is painted.
    await page.waitForFunction((expected) => document.title === expected, `${title} - strainsite`);
  }
  complaints.splice(0, complaints.length, ...complaints.filter((text) => !/status of 404 /.test(text)));
  await page.getByRole("button", { name: "studies and sweeps that are here" }).click();
  assert.equal(await page.evaluate(() => document.activeElement?.id), "lists");
  await hold();
  await page.locator("main").getByRole("link", { name: "New study" }).click();
  await page.waitForFunction(() => document.title === "New study - strainsite");
});

test("a sweep with a design that failed, its designs side by side, and the failure itself", { timeout: STUDY_MS }, async () => {
  // With next to no textile the tire has its limit point below its pressure.
  const sweep = await sent("/sweeps", { study: STUDY, grid: { "carcass.stiffness_n_per_mm": [1, 50, 100] } });
  await page.goto(`${service.url}/#/sweeps/${sweep}`);
  await page.locator(".study-head .badge-done").waitFor({ timeout: STUDY_MS });
  await page.getByRole("heading", { name: "What differs" }).waitFor();
  await hold();
  const { designs } = await (await fetch(`${service.url}/v1/sweeps/${sweep}`)).json();
  const done = designs.filter(({ study }) => study.state === "done").map(({ study }) => study.id);
  assert.equal(done.length, 2);
  await page.goto(`${service.url}/#/compare?studies=${done.join(",")}`);
  await page.getByRole("table", { name: "Documents, field by field" }).waitFor();
  await hold();
  await page.goto(`${service.url}/#/studies/${designs.find(({ study }) => study.state === "failed").study.id}`);
  await page.locator(".study-head .badge-failed").waitFor();
  assert.match(await page.getByRole("alert").first().innerText(), /limit-point/);
  await hold();
});

test("a running study tells of its solves, and a cancelled one says how it goes on", async () => {
  cancelled = await sent("/studies", { ...LONG, name: "cancelled", accuracy: { preset: "reference" } });
  await page.goto(`${service.url}/#/studies/${cancelled}`);
  await page.locator(".current-solves li").first().waitFor({ timeout: STUDY_MS });
  assert.match(await page.locator(".current-solves li").first().innerText(), /Point \d+: (inflating|pressing).*, iteration \d+, residual \de[+-]\d+/);
  await hold();
  await fetch(`${service.url}/v1/studies/${cancelled}`, { method: "DELETE" });
  await page.goto(`${service.url}/#/studies/${cancelled}`);
  await page.locator(".study-head .badge-cancelled").waitFor();
  await hold();
});

test("keys alone lead to the map within eight Tabs, to a place that stays, and to another study", { timeout: STUDY_MS }, async (t) => {
  const first = await sent("/studies", { ...STUDY, name: "by keys" });
  await page.goto("about:blank");
  await page.goto(`${service.url}/#/studies/${first}/tire`);
  await page.locator(".map canvas").waitFor({ timeout: STUDY_MS });
  const focused = () => page.evaluate(() => document.activeElement.className || document.activeElement.tagName);
  let tabs = 0;
  do {
    await page.keyboard.press("Tab");
    tabs += 1;
  } while ((await focused()) !== "map" && tabs < 3 * TABS);
  t.diagnostic(`${tabs} Tabs to the map`);
  assert.ok(tabs <= TABS, `${tabs} Tabs`);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Enter");
  await page.locator(".map .pin").waitFor();

  // Back to the colours, then to the sections, whose arrows go round.
  for (let back = 0; back < 3; back += 1) await page.keyboard.press("Shift+Tab");
  await page.keyboard.press("ArrowRight");
  await page.waitForURL(/quantity=/);
  await page.keyboard.press("Shift+Tab");
  await page.keyboard.press("Shift+Tab");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Enter");
  await page.waitForURL(/\/run/);

  // The list is one stop, with entries above one another.
  const list = page.locator(".study-list");
  const chosen = list.locator(`a[href*="${first}"]`);
  assert.equal(await list.locator('a[tabindex="0"], button[tabindex="0"], input[tabindex="0"]').count(), 1);
  await chosen.focus();
  const links = await list.locator("a").evaluateAll((all) => all.map(({ hash }) => hash.split("/")[2]));
  const way = Math.sign(links.indexOf(cancelled) - links.indexOf(first));
  for (let at = links.indexOf(first); at !== links.indexOf(cancelled); at += way) await page.keyboard.press(way > 0 ? "ArrowDown" : "ArrowUp");
  await page.keyboard.press("Enter");
  await page.waitForURL(new RegExp(cancelled));
  assert.deepEqual(complaints.splice(0), []);
});

test("a study whose service is killed stands still on the page, and goes on to its result by itself", { timeout: STUDY_MS }, async (t) => {
  const id = await sent("/studies", LONG);
  await page.goto(`${service.url}/#/studies/${id}`);
  await page.locator(".study-head .badge-running").waitFor();
  const points = () => page.locator(".facts div").filter({ hasText: "Points" }).locator("dd").innerText();
  const solved = async () => Number.parseInt(await points(), 10);
  while ((await solved()) < 3) await page.waitForTimeout(50);
  await service.kill();
  const before = await solved();
  await page.getByText("The service hasn't answered since").waitFor({ timeout: 15_000 });
  const clock = page.locator(".facts div").filter({ hasText: "Elapsed" }).locator("dd");
  const stood = await clock.innerText();
  await page.waitForTimeout(2200);
  assert.equal(await clock.innerText(), stood, "the clock stands");
  for (const viewport of [...WINDOWS].reverse()) {
    await page.setViewportSize(viewport);
    for (const colorScheme of ["dark", "light"]) {
      await page.emulateMedia({ colorScheme });
      assert.deepEqual(await violations(page), [], `without its service, ${viewport.width} px, ${colorScheme}`);
    }
  }
  await service.restart();
  await page.locator(".answer-sentence").waitFor({ timeout: STUDY_MS });
  const others = complaints.splice(0).filter((text) => !/ERR_(CONNECTION_REFUSED|INCOMPLETE_CHUNKED_ENCODING|CONNECTION_RESET|EMPTY_RESPONSE)/.test(text));
  assert.deepEqual(others, [], "only refused requests are told");
  // Of both meshes, whose points are solved at the same time.
  const told = await (await fetch(`${service.url}/v1/studies/${id}/events`)).text();
  const begun = [...told.matchAll(/^event: started\n(?:.*\n)*?data: (.*)$/gm)].map(([, data]) => JSON.parse(data));
  const kept = begun[1].reused;
  t.diagnostic(`${before} points were solved when it was killed, ${kept} of them not again`);
  assert.ok(kept >= before - 1, `${kept} of ${before} points were kept`);
});

test("a term says what it means when it is pressed, and Escape closes that and gives the focus back", { timeout: STUDY_MS }, async () => {
  await page.goto(`${page.url().split("#")[0]}#/studies/${page.url().split("/").at(-1)}/indices`);
  const word = page.getByRole("button", { name: "M-DRM", exact: true });
  await word.focus();
  await page.keyboard.press("Enter");
  const meaning = page.getByText("the strain as a product of functions of one input each");
  await meaning.waitFor();
  assert.deepEqual(await violations(page), []);
  await page.keyboard.press("Escape");
  await meaning.waitFor({ state: "hidden" });
  assert.ok(await word.evaluate((button) => document.activeElement === button));
  await page.keyboard.press("?");
  await page.getByText("All terms, in a sentence or two").click();
  await page.getByRole("dialog").getByText("Cramér–Rao bound").waitFor();
  await hold();
});
