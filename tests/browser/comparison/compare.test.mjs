// Studies side by side: baseline, scale and difference maps; a sweep over two fields as a grid.
// STRAINSITE_PAGE is the address of a page in front of a service of its own, for those who work on the page.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { openBrowser, openPage, savedTexts, setting, SOFTWARE_WEBGL, violations } from "../page.mjs";
import { startService } from "../service.mjs";

const STUDY_MS = Number(process.env.STRAINSITE_STUDY_MS ?? 600_000);
const WIDE = { viewport: { width: 1280, height: 900 } };
const NARROW = { viewport: { width: 390, height: 844 } };
const PLACES = 20;
const ROW = 120;

let service;
let browser;
let root;
let studies;
let sweep;

before(
  async () => {
    if (process.env.STRAINSITE_PAGE === undefined) service = await startService();
    root = process.env.STRAINSITE_PAGE ?? service.url;
    browser = await openBrowser(SOFTWARE_WEBGL);
    const { studies: presets } = await json("/v1/presets");
    const { document } = presets.find(({ name }) => name === "foot-tire");
    const quick = {
      ...document,
      layouts: { spacings_deg: [60, 90], positions: ["crown"], depths_mm: [1] },
      method: { kind: "mdrm", nodes: 3, check_points: 2 },
    };
    const mapped = { ...quick, candidates: { points: "P1-P5", grid: { circumferential: 21, meridional: 9 } } };
    // Of the coarse mesh errors are known, of a draft they aren't.
    const walls = [
      [3, "coarse"],
      [2.5, "coarse"],
      [3.5, "draft"],
    ].map(([wall_mm, preset]) => ({
      ...mapped,
      name: `wall ${wall_mm}`,
      scene: { ...document.scene, geometry: { wall_mm } },
      accuracy: { preset },
    }));
    studies = [];
    for (const wall of walls) studies.push((await sent("/v1/studies", wall)).id);
    const grid = { "geometry.wall_mm": [2.5, 3], "carcass.angle_deg": [50, 60] };
    sweep = (
      await sent("/v1/sweeps", {
        name: "wall and cord",
        study: { ...quick, name: "draft", accuracy: { preset: "draft" }, candidates: { points: "P1-P5" } },
        grid,
      })
    ).id;
    for (const path of [...studies.map((id) => `/v1/studies/${id}`), `/v1/sweeps/${sweep}`]) await done(path);
  },
  { timeout: STUDY_MS },
);

after(async () => {
  await browser?.close();
  await service?.stop();
});

async function json(path) {
  const answer = await fetch(root + path);
  assert.ok(answer.ok, `${path}: ${answer.status}`);
  return answer.json();
}

async function sent(path, document) {
  const answer = await fetch(root + path, { method: "POST", body: JSON.stringify(document), headers: { "Content-Type": "application/json" } });
  assert.equal(answer.status, 202, await answer.clone().text());
  return answer.json();
}

async function done(path) {
  for (;;) {
    const { state } = await json(path);
    if (state === "done") return;
    assert.ok(state === "queued" || state === "running", `${path} is ${state}`);
    await new Promise((resolve) => setTimeout(resolve, 200));
  }
}

async function openCompared(query = "", options = WIDE) {
  const opened = await openPage(browser, { reducedMotion: "reduce", ...options });
  await opened.page.goto(`${root}/#/compare?studies=${studies.join(",")}${query}`);
  await opened.page.getByRole("heading", { name: "Difference maps" }).waitFor();
  await opened.page.getByRole("heading", { name: "What differs", exact: true }).waitFor();
  return opened;
}

/** The number and its error in a cell of the reading; null where there is a dash. */
function figures(text) {
  const numbers = text
    .replaceAll("−", "-")
    .replace(/[\s\u202f]/g, "")
    .match(/-?\d+(\.\d+)?/g);
  return numbers === null ? null : numbers.map(Number);
}

test("the baseline is in the address and survives a reload", async () => {
  const { page, complaints } = await openCompared();
  const entries = await page.evaluate(() => history.length);
  await page.getByLabel("Baseline").selectOption({ label: "2: wall 2.5" });
  await page.waitForURL(new RegExp(`baseline=${studies[1]}`));
  assert.equal(await page.evaluate(() => history.length), entries);
  await page.reload();
  await page.locator(".compared-difference").waitFor();
  assert.equal(await page.getByLabel("Baseline").inputValue(), studies[1]);
  const against = await page.locator(".compared-difference > div").evaluateAll((maps) => maps.map((map) => map.dataset.study));
  assert.deepEqual(against, [studies[0], studies[2]]);
  await page.locator("tr.baseline th").first().filter({ hasText: "wall 2.5" }).waitFor();
  assert.equal(await page.locator("table.layout-ranks thead th:nth-child(3)").innerText(), "2 baseline");
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("what answers best comes first, with films against error of each", async () => {
  const { page, complaints } = await openCompared();
  const { answer, studies: found } = await json(`/v1/comparison?studies=${studies.join(",")}`);
  assert.equal(await page.locator("main h2").first().innerText(), "Which answers best");
  const lead = answer.sentence.slice(0, answer.sentence.indexOf(":"));
  assert.ok((await page.locator("main .headline").first().innerText()).startsWith(lead));
  const best = [...found].sort((a, b) => a.answer.rank - b.answer.rank).map(({ name }) => name);
  const rows = await page.locator("table.answers tbody th a").allInnerTexts();
  assert.deepEqual(rows, best);
  assert.equal(await page.locator(".compared-trades .layout-curve > path").count(), 2 * found.length);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("pictures of maps have the legend of their section", async () => {
  const { page } = await openCompared();
  assert.match(await savedTexts(page, "values 1"), /values 1 .*one scale for all .*nothing was computed/);
  assert.match(await savedTexts(page, "difference 2"), /minus the baseline ?; one scale for all .*White is no difference/);
  await page.context().close();
});

test("a difference is that of the two maps, its error the root of both errors' squares", async () => {
  const { page, complaints } = await openCompared("&input=P3");
  const [base, other] = await Promise.all([0, 1].map((k) => json(`/v1/studies/${studies[k]}/map?direction=x&input=P3`)));
  const map = page.locator(`.compared-difference > div[data-study="${studies[1]}"] .map`);
  await map.focus();
  await page.keyboard.press("ArrowRight");
  const keys = ["ArrowLeft", "ArrowUp", "ArrowLeft", "ArrowDown", "ArrowLeft"];
  const read = new Set();
  let compared = 0;
  for (let k = 0; read.size < PLACES && k < 4 * PLACES; k += 1) {
    const seen = await page.evaluate((study) => {
      const { theta, phi } = document.querySelector(".compared .readout strong").dataset;
      return { theta: Number(theta), phi: Number(phi), text: document.querySelector(`.compared .point-table tr[data-study="${study}"]`).cells[2].innerText };
    }, studies[1]);
    const at = base.phi_deg.indexOf(seen.phi) * base.theta_deg.length + base.theta_deg.indexOf(seen.theta);
    const [i, j] = [other.first_order[at], base.first_order[at]];
    const shown = figures(seen.text);
    if (i === null || j === null) assert.equal(shown, null, seen.text);
    else {
      compared += 1;
      assert.ok(Math.abs(shown[0] - 100 * (i - j)) < 0.0051, `${seen.text} is ${100 * (i - j)}`);
      assert.ok(Math.abs(shown[1] - 100 * Math.hypot(other.error[at], base.error[at])) < 0.0051, seen.text);
    }
    read.add(at);
    await page.keyboard.press(k < 2 * PLACES ? keys[k % keys.length] : "ArrowRight");
  }
  assert.ok(read.size >= PLACES && compared > PLACES / 2, `${read.size} places, ${compared} with an index`);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("all maps have one scale, which reaches as far as the largest of them", async () => {
  const { page } = await openCompared("&quantity=strain&direction=y");
  const results = await Promise.all(studies.map((id) => json(`/v1/studies/${id}/result`)));
  const strains = results.flatMap(({ map }) => map.layers.find(({ direction }) => direction === "y").strain);
  const peak = 1e6 * Math.max(...strains.map(Math.abs));
  assert.equal(await page.locator(".compared").first().locator(".scale-strip").count(), 1);
  const name = await page.locator(".compared").first().locator(".scale-strip").getAttribute("aria-label");
  const [low, high] = figures(name.replace("Colours from", "").replace(" to ", ";"));
  assert.ok(Math.abs(high - peak) < 1 && Math.abs(low + peak) < 1, `${name} is ${peak}`);
  await page.context().close();
});

test("what turns one tire turns all, and a link shows them so", async () => {
  const { page, complaints } = await openCompared("&as=tires&quantity=std");
  const drawn = page.locator('.compared-wheels canvas[data-drawn="yes"]');
  await drawn.nth(2).waitFor();
  const places = () => page.locator(".compared-wheels .wheel").evaluateAll((wheels) => wheels.map((wheel) => wheel.querySelector(".wheel-label").style.left));
  const before = await places();
  await page.locator(".compared-wheels .wheel").first().focus();
  await page.keyboard.press("ArrowRight");
  const turned = await places();
  turned.forEach((left, k) => assert.notEqual(left, before[k], `tire ${k + 1} turns`));
  await page.waitForURL(/eye=/);
  await page.reload();
  await drawn.nth(2).waitFor();
  assert.deepEqual(await places(), turned);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("a sweep over two fields is a grid, whose cells are reached by the keyboard", async () => {
  const { page, complaints } = await openPage(browser, { ...WIDE, colorScheme: "dark" });
  await page.goto(`${root}/#/sweeps/${sweep}?figure=index-x`);
  const grid = page.getByRole("table", { name: "Designs by two fields" });
  await grid.locator(".figure-coloured").nth(3).waitFor();
  const comparison = await json(`/v1/comparison?sweep=${sweep}`);
  const { designs } = await json(`/v1/sweeps/${sweep}`);
  const shown = await grid
    .locator("tbody tr")
    .evaluateAll((rows) => rows.map((row) => [...row.cells].map((cell) => cell.querySelector("strong")?.innerText ?? cell.innerText)));
  assert.deepEqual(
    shown.map(([wall]) => wall),
    ["2.5", "3"],
  );
  for (const { set, study } of designs) {
    const { best } = comparison.studies.find(({ id }) => id === study.id);
    const { gsi_percent } = comparison.rows.find((row) => row.study === study.id && row.location === best).x;
    const row = shown.find(([wall]) => wall === String(set["geometry.wall_mm"]));
    assert.equal(row[set["carcass.angle_deg"] === 50 ? 1 : 2], gsi_percent.toFixed(1));
  }
  assert.deepEqual(await violations(page), []);
  await page.locator('label:has(input[value="angle-error"])').click();
  await page.waitForURL(/figure=angle-error/);
  const { answer } = await json(`/v1/studies/${designs[0].study.id}/result?map=false`);
  await grid.getByText(answer.layout.angle_error_deg.toFixed(1), { exact: true }).first().waitFor();
  await grid.locator("tbody a").first().focus();
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await page.waitForURL(new RegExp(designs[1].study.id));
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("designs are ticked in their table and compared", async () => {
  const { page } = await openPage(browser, WIDE);
  await page.goto(`${root}/#/sweeps/${sweep}`);
  for (const name of ["Compare wall_mm = 2.5, angle_deg = 50", "Compare wall_mm = 3, angle_deg = 60"])
    await page.getByRole("table", { name: "Designs", exact: true }).getByLabel(name).check();
  await page.getByRole("link", { name: "Compare the 2 ticked" }).click();
  await page.getByRole("heading", { name: "Compare 2 studies" }).waitFor();
  await page.getByText("This study asked for no map.").first().waitFor();
  await page.context().close();
});

for (const [options, colorScheme] of [
  [WIDE, "light"],
  [NARROW, "dark"],
]) {
  test(`the comparison keeps the rules, ${options.viewport.width} px wide, ${colorScheme}`, async () => {
    const { page, complaints } = await openCompared("&pin=0,0", { ...options, colorScheme });
    assert.deepEqual(await violations(page), []);
    const { small, rows, overflow } = await setting(page, ROW);
    assert.deepEqual(small, [], "texts below 11 px");
    if (options === NARROW) assert.deepEqual(rows, [], `rows above ${ROW} px`);
    assert.ok(overflow <= 0, `the page is ${overflow} px wider than its window`);
    assert.deepEqual(complaints, []);
    await page.context().close();
  });
}
