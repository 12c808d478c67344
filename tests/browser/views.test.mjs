// Every section of a finished study by its link: rules of accessibility, sizes, the answer without scrolling, keys, colours, files and paper.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { mkdirSync } from "node:fs";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { openBrowser, openPage, overlaps, savedTexts, setting, violations } from "./page.mjs";
import { startService } from "./service.mjs";

const SCREENSHOTS = fileURLToPath(new URL("screenshots/", import.meta.url));
const SECTIONS = ["answer", "tire", "layouts", "indices", "trade", "run"];
const WINDOWS = [
  { width: 1440, height: 900 },
  { width: 390, height: 844 },
];
/** Highest row of a table in a narrow window, px. */
const ROW = 120;
/** What the answer may take on the wire. */
const ANSWER_BYTES = 120_000;
const STUDY_MS = 300_000;
const depth = (station) => ({ name: `P${station + 1}`, vary: `ground.depths_mm[${station}]`, distribution: { kind: "uniform", min: 0.7, max: 1.3 } });
const STUDY = {
  name: "five depths on the draft mesh",
  scene: { preset: "foot-tire" },
  inputs: [0, 1, 2, 3, 4].map(depth),
  candidates: { points: "P1-P5", grid: { circumferential: 21, meridional: 9 } },
  layouts: { spacings_deg: [30, 60, 90], positions: ["crown", "shoulder", "sidewall"], depths_mm: [1, 2] },
  method: { kind: "mdrm", nodes: 3 },
  accuracy: { preset: "draft" },
};

let service;
let browser;
let id;

/** The page itself, or another address that passes its questions on to the service: a page that isn't built into the binary yet. */
const origin = () => process.env.STRAINSITE_PAGE ?? service.url;

before(async () => {
  mkdirSync(SCREENSHOTS, { recursive: true });
  service = process.env.STRAINSITE_PAGE === undefined ? await startService() : null;
  browser = await openBrowser();
  const answer = await fetch(`${origin()}/v1/studies`, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(STUDY) });
  ({ id } = await answer.json());
  const deadline = Date.now() + STUDY_MS;
  for (let state = ""; state !== "done"; ) {
    assert.ok(Date.now() < deadline && state !== "failed", `the study is ${state}`);
    await new Promise((resolve) => setTimeout(resolve, 200));
    ({ state } = await (await fetch(`${origin()}/v1/studies/${id}`)).json());
  }
});

after(async () => {
  await browser?.close();
  await service?.stop();
});

/** Opens a section and waits until it is drawn. */
async function openSection(section, options) {
  const opened = await openPage(browser, options);
  await opened.page.goto(`${origin()}/#/studies/${id}/${section}`);
  await opened.page.locator("#section").waitFor();
  if (section === "tire") await opened.page.locator("#section section").first().waitFor();
  return opened;
}

for (const viewport of WINDOWS) {
  for (const section of SECTIONS) {
    test(`${section}, ${viewport.width} px wide, light and dark`, { timeout: 60_000 }, async () => {
      const { page, complaints } = await openSection(section, { viewport, colorScheme: "light" });
      assert.equal(await page.locator(".sections [aria-current]").innerText(), section[0].toUpperCase() + section.slice(1));
      const open = section === "answer" ? "\\d+ films along .+" : section;
      await page.waitForFunction((title) => new RegExp(title).test(document.title), `^five depths on the draft mesh: ${open} - strainsite$`);
      for (const colorScheme of ["light", "dark"]) {
        await page.emulateMedia({ colorScheme });
        await page.screenshot({ path: `${SCREENSHOTS}${section}-${viewport.width}-${colorScheme}.png`, fullPage: true });
        assert.deepEqual(await violations(page), [], colorScheme);
      }
      const { small, rows, overflow } = await setting(page, ROW);
      assert.deepEqual(small, [], "texts below 11 px");
      if (viewport.width < 500) assert.deepEqual(rows, [], `rows above ${ROW} px`);
      assert.ok(overflow <= 0, `the page is ${overflow} px wider than its window`);
      assert.deepEqual(await overlaps(page), [], "texts on each other");
      assert.deepEqual(complaints, []);
      await page.context().close();
    });
  }
}

for (const viewport of WINDOWS) {
  for (const colorScheme of ["light", "dark"]) {
    test(`the page of the operations, ${viewport.width} px wide, ${colorScheme}`, { timeout: 60_000 }, async () => {
      const { page, complaints } = await openPage(browser, { viewport, colorScheme });
      await page.goto(`${origin()}/docs`);
      const entries = page.locator("section[aria-labelledby=all-title] details");
      await entries.first().waitFor();
      const all = await entries.count();
      assert.deepEqual(await violations(page), []);
      const { small, overflow } = await setting(page, ROW);
      assert.deepEqual(small, [], "texts below 11 px");
      assert.ok(overflow <= 0, `the page is ${overflow} px wider than its window`);
      await page.getByLabel("Filter").fill("post estimate");
      const left = await entries.count();
      assert.ok(left > 0 && left < all, `${left} of ${all}`);
      await entries.first().locator("summary").click();
      assert.deepEqual(await violations(page), []);
      assert.deepEqual(complaints, []);
      await page.context().close();
    });
  }
}

for (const viewport of WINDOWS) {
  test(`the answer is read without scrolling at ${viewport.width} x ${viewport.height}`, { timeout: 60_000 }, async (t) => {
    const { page } = await openSection("answer", { viewport });
    const words = (await page.locator("main").innerText()).split(/\s+/).filter((word) => word !== "").length;
    t.diagnostic(`${words} words`);
    // Four of them are the link to the sheet.
    assert.ok(words < 124, `${words} words`);
    for (const part of [
      ".answer-sentence",
      ".answer-sure .verdict",
      ".answer-facts",
      ".wheel",
      ".wheel-section",
      ...(viewport.width > 400 ? [".trade-plot"] : []),
    ]) {
      const { y, height } = await page.locator(part).first().boundingBox();
      assert.ok(y >= 0 && y + height <= viewport.height, `${part} ends at ${y + height} px`);
    }
    const { answer } = await (await fetch(`${origin()}/v1/studies/${id}/result?map=false`)).json();
    assert.equal(await page.locator(".wheel .wheel-film").count(), answer.layout.film_count, "every film of the answer is drawn");
    await page.context().close();
  });
}

test("the answer takes few bytes", { timeout: 60_000 }, async (t) => {
  const { page } = await openSection("answer", { viewport: WINDOWS[0] });
  await page.waitForLoadState("networkidle");
  const sizes = await page.evaluate(() =>
    performance
      .getEntries()
      .filter(({ transferSize }) => transferSize > 0)
      .map(({ name, transferSize }) => [name.split("/").at(-1), transferSize]),
  );
  const bytes = sizes.reduce((sum, [, size]) => sum + size, 0);
  t.diagnostic(`${bytes} bytes: ${JSON.stringify(sizes)}`);
  assert.ok(sizes.some(([name]) => name === "result?map=false") && bytes < ANSWER_BYTES, `${bytes} bytes`);
  await page.context().close();
});

test("a film is dragged, its bounds follow, and undo takes it back", { timeout: 60_000 }, async () => {
  const { page, complaints } = await openSection("layouts", { viewport: WINDOWS[0] });
  await page.getByText("Move films", { exact: true }).click();
  const films = page.getByRole("group", { name: "Films by their angle around the wheel" }).getByRole("button");
  await films.first().waitFor();
  const before = await films.allInnerTexts();
  const drawing = page.getByRole("img", { name: `${before.length} films that can be moved` });
  const { x, y, width } = await drawing.boundingBox();
  // The film at 0 degrees is the lowest; positive angles are to the right.
  const [middle, arm] = [{ x: x + width / 2, y: y + width / 2 }, 0.4 * width];
  const at = (angle) => [middle.x + arm * Math.sin((angle * Math.PI) / 180), middle.y + arm * Math.cos((angle * Math.PI) / 180)];
  await page.mouse.move(...at(0));
  await page.mouse.down();
  await page.mouse.move(...at(10), { steps: 4 });
  await page.mouse.move(...at(17), { steps: 4 });
  await page.mouse.up();
  const moved = await films.allInnerTexts();
  const changed = before.filter((text, k) => text !== moved[k]);
  assert.deepEqual(changed.length, 1, `${before} became ${moved}`);
  assert.ok(
    moved.some((text) => text.includes(" 17°")),
    moved.join(", "),
  );
  await page.waitForURL(/films=/);
  await page.getByText("the layout it came from").first().waitFor();
  for (const viewport of WINDOWS) {
    await page.setViewportSize(viewport);
    for (const colorScheme of ["light", "dark"]) {
      await page.emulateMedia({ colorScheme });
      assert.deepEqual(await violations(page), [], `${viewport.width} px, ${colorScheme}`);
    }
    const { small, overflow } = await setting(page, 1e9);
    assert.deepEqual(small, [], "texts below 11 px");
    assert.ok(overflow <= 0, `the page is ${overflow} px wider than its window`);
  }
  await page.getByRole("button", { name: "Undo" }).click();
  assert.deepEqual(await films.allInnerTexts(), before);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("the first view asks for no map, and the tire's section does", { timeout: 60_000 }, async () => {
  const { page, requests } = await openSection("answer", { viewport: WINDOWS[0] });
  const results = () => requests.filter((url) => /\/result(\?|$)/.test(url)).map((url) => new URL(url).search);
  assert.deepEqual(results(), ["?map=false"]);
  await page.getByRole("link", { name: "Tire", exact: true }).click();
  await page.locator("#section section").first().waitFor();
  const service = await (await fetch(`${origin()}/v1/studies/${id}/result?map=false`)).json();
  // A service that doesn't know the question sends the map with the first answer.
  assert.deepEqual(results(), service.map == null ? ["?map=false", ""] : ["?map=false"]);
  await page.context().close();
});

test("the wheel turns by keys and by hand, to its worst angle, and says what is known there", { timeout: 60_000 }, async (t) => {
  const { page } = await openSection("layouts", { viewport: WINDOWS[0] });
  const wheel = page.getByRole("slider", { name: "Angle of the wheel that touches down" });
  await wheel.focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Shift+ArrowRight");
  assert.equal(await wheel.getAttribute("aria-valuenow"), "11");
  await page.keyboard.press("w");
  const { layouts, findings } = await (await fetch(`${origin()}/v1/studies/${id}/layouts`)).json();
  const best = layouts.find(({ rank }) => rank === 1);
  const atRing = best.loads.find(({ depth_mm }) => Math.abs(depth_mm - findings.rings[0].depth_mm) < 1e-9);
  const told = await wheel.getAttribute("aria-valuetext");
  t.diagnostic(`${told}; the service's worst bound is ${atRing.score.worst_angle_error_deg}`);
  const bound = Number(/to ([\d.]+)°/.exec(told)[1]);
  assert.ok(Math.abs(bound / atRing.score.worst_angle_error_deg - 1) < 0.06, "two digits of the service's own figure");
  const { x, y, width, height } = await wheel.boundingBox();
  const before = await wheel.getAttribute("aria-valuenow");
  await page.mouse.move(x + width / 2, y + height * 0.8);
  await page.mouse.down();
  await page.mouse.move(x + width * 0.8, y + height * 0.5, { steps: 5 });
  await page.mouse.up();
  assert.notEqual(await wheel.getAttribute("aria-valuenow"), before);
  assert.equal(await page.getByRole("table", { name: "Readings of the films" }).locator("tbody tr").count(), best.film_count);
  await page.context().close();
});

test("keys are listed, open sections, and can be turned off", { timeout: 60_000 }, async () => {
  const { page } = await openSection("answer", { viewport: WINDOWS[0] });
  await page.keyboard.press("4");
  await page.waitForURL(/\/indices$/);
  await page.keyboard.press("?");
  const dialog = page.getByRole("dialog", { name: "Keys" });
  await dialog.waitFor();
  assert.deepEqual(await violations(page), []);
  await dialog.getByRole("checkbox").uncheck();
  await page.keyboard.press("Escape");
  await dialog.waitFor({ state: "detached" });
  await page.keyboard.press("1");
  assert.match(page.url(), /\/indices$/, "single keys are off");
  await page.context().close();
});

test("the skip link leads to the section in one Tab", { timeout: 60_000 }, async () => {
  const { page } = await openSection("tire", { viewport: WINDOWS[0] });
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  assert.equal(await page.evaluate(() => document.activeElement?.id), "section");
  await page.context().close();
});

test("colours are the reader's choice, and stay so", { timeout: 60_000 }, async () => {
  const { page } = await openSection("answer", { viewport: WINDOWS[0], colorScheme: "light" });
  const ground = () => page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
  const light = await ground();
  await page.getByLabel("Colours").selectOption("dark");
  const dark = await ground();
  assert.notEqual(dark, light);
  await page.reload();
  await page.locator("#section").waitFor();
  assert.equal(await ground(), dark);
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.locator(".sidebar").isVisible(), false);
  const ink = await page.evaluate(() => getComputedStyle(document.querySelector(".answer-sentence")).color);
  assert.equal(ink, "rgb(22, 32, 43)", "paper is white, whatever the screen is");
  await page.context().close();
});

test("figures are saved as SVG and PNG, tables as CSV", { timeout: 60_000 }, async () => {
  const { page } = await openSection("indices", { viewport: WINDOWS[0] });
  const saved = async (name) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name }).click()]);
    return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
  };
  const svg = await saved("Save indices-x as SVG");
  assert.equal(svg.name, "five-depths-on-the-draft-mesh-indices-x.svg");
  assert.match(svg.bytes.toString(), /^<svg [^>]*xmlns="http:\/\/www.w3.org\/2000\/svg".*P3/s);
  const png = await saved("Save indices-x as PNG");
  assert.deepEqual([...png.bytes.subarray(1, 4)].map((code) => String.fromCharCode(code)).join(""), "PNG");
  assert.ok(png.bytes.length > 3000, `${png.bytes.length} bytes`);
  const csv = await page.getByRole("link", { name: "Ranked locations as CSV" }).getAttribute("href");
  assert.match(await (await fetch(new URL(csv, page.url()))).text(), /P3/);
  await page.context().close();
});

test("each picture has its study's name, its figure's and its legend", { timeout: 60_000 }, async () => {
  const { page } = await openSection("answer", { viewport: WINDOWS[0] });
  const { paths } = JSON.parse(await readFile(fileURLToPath(new URL("../../web/openapi.json", import.meta.url))));
  const trade = paths["/v1/studies/{id}/trade"].get.responses[200].content["application/json"].example;
  await page.route("**/trade", (route) => route.fulfill({ json: trade }));
  await page.route(`**/studies/${id}`, async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, json: { ...(await response.json()), trade_measured: true } });
  });
  for (const [section, figure, legend] of [
    ["answer", "answer", /x, around y, across/],
    ["tire", "map of index x", /First-order index of P3, .* 0 .*100 .* nothing was computed/],
    ["layouts", "layouts", /crown .*shoulder .*x\+y .*the paper's layout/],
    ["layouts", "wheel", /x, around y, across/],
    ["indices", "indices-x", /percent .*valid index and its error/],
    ["trade", "trade", /true error; the line is the Pareto front .*that the rung claims/],
  ]) {
    await page.goto("about:blank");
    await page.goto(`${origin()}/#/studies/${id}/${section}`);
    const texts = await savedTexts(page, figure);
    assert.ok(texts.startsWith(`five depths on the draft mesh: ${figure} `), texts);
    assert.match(texts, legend);
  }
  await page.context().close();
});

test("the paper's figures stand beside the study's on demand", { timeout: 60_000 }, async () => {
  const { page } = await openSection("indices", { viewport: WINDOWS[0] });
  assert.equal(await page.getByRole("columnheader", { name: /Paper/ }).count(), 0);
  await page.getByRole("checkbox", { name: /Compare with the paper/ }).check();
  assert.equal(await page.getByRole("columnheader", { name: /Paper/ }).count(), 2);
  assert.match(await page.locator('tr[data-location="P3"]').innerText(), /29\.97/);
  assert.deepEqual(await violations(page), []);
  await page.context().close();
});
