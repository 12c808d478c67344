// Layouts on a study's page: the answer in a sentence, the plot, the tables.
import assert from "node:assert/strict";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { openBrowser, openPage } from "./page.mjs";
import { startService } from "./service.mjs";

const SCREENSHOTS = fileURLToPath(new URL("screenshots/", import.meta.url));
const STUDY = {
  name: "layouts",
  scene: { preset: "foot-tire" },
  inputs: [{ name: "depth", vary: "ground.depths_mm[2]", distribution: { kind: "uniform", min: 0.7, max: 1.3 } }],
  layouts: {
    depths_mm: [1, 2],
    spacings_deg: [90, 60, 30],
    units: [8, 9],
    positions: ["crown", "sidewall"],
    directions: [["x", "y"], ["y"]],
    staggered: true,
    search: { films: [3], slots: 12, section_deg: [0], directions: ["x", "y"] },
  },
  method: { kind: "mdrm", nodes: 3, check_points: 0 },
  accuracy: { preset: "draft" },
};

const WEB = fileURLToPath(new URL("../../web/", import.meta.url));
const LAYOUTS = 50;
/** Relative; both sum the same terms in the same order, which leaves the last digits. */
const EQUAL = 1e-9;
const HAND_STUDY = {
  name: "by hand",
  scene: { preset: "foot-tire" },
  inputs: [{ name: "depth", vary: "ground.depths_mm[2]", distribution: { kind: "uniform", min: 0.7, max: 1.3 } }],
  layouts: {
    depths_mm: [1, 2],
    units: [12, 24],
    spacings_deg: [],
    positions: ["crown", "shoulder"],
    directions: [["x", "y"], ["y"]],
    gain_std: 0.05,
    place_std_deg: 1,
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
  await page.goto(`${service.url}/#/studies/${id}/layouts`);
  const panel = page.locator('section[aria-labelledby="layouts-title"]');
  await panel.waitFor({ timeout: 540_000 });
  const { layouts, findings } = await (await fetch(`${service.url}/v1/studies/${id}/layouts`)).json();

  const [best] = layouts;
  const [first, papers] = await panel.locator(".layout-answer p").allInnerTexts();
  t.diagnostic(`${first} | ${papers}`);
  const digits = (value) => String(Number(value.toPrecision(Math.max(2, Math.floor(Math.log10(value)) + 1))));
  assert.match(first, new RegExp(`${best.film_count} films along .* at the ${best.position}, .* every [\\d.]+°`));
  assert.ok(first.includes(`the contact angle to ${digits(best.score.simulated_p95_angle_error_deg)}`), first);
  const atLoads = layouts[0].loads.map((load) => load.score.force_error_n);
  assert.equal(best.worst_force.error_n, Math.max(...atLoads));
  assert.ok(first.includes(`the vertical force to ${digits(best.worst_force.error_n)}`), first);
  assert.match(
    papers,
    /The paper's layout, 12 films along x and y at the crown, a pair every 60°, ranks \d+ of \d+: it would know the contact angle to [\d.]+/,
  );

  // Two positions by three sets of films, each over five numbers of units; y alone isn't staggered.
  const plot = panel.locator("svg.layout-plot");
  const points = () => plot.locator("title").allTextContents();
  assert.equal(await plot.locator(".layout-curve").count(), 6);
  assert.equal((await points()).length, layouts.filter((layout) => layout.spacing_deg !== null).length);
  assert.equal(await plot.locator(".papers-mark").count(), 1);
  assert.deepEqual(await plot.locator(".axis .papers").allTextContents(), ["6", "60°"]);
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
  const grounds = page.locator('section[aria-labelledby="grounds-title"]');
  const rowsOf = (name) => grounds.getByRole("table", { name }).locator("tbody tr").count();
  assert.equal(await rowsOf("Best layout for each number of films"), findings.front.length);
  assert.equal(await rowsOf("From how many units on a ring is dense enough"), findings.loads[0].knees.length);
  assert.equal(await rowsOf("Searched layouts"), findings.searches.length);
  assert.equal(await rowsOf("Kinds of film by several criteria"), findings.candidates.length);

  await page.setViewportSize({ width: 390, height: 800 });
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.ok(wide <= 0, `the page is ${wide} px wider than its window`);
  assert.deepEqual(complaints, []);
});

/** Gives the page's modules below `lib/layouts/moving` as Node runs them, with what they import. */
function pageModules(t) {
  const { transpileModule, ModuleKind, ScriptTarget } = createRequire(`${WEB}package.json`)("typescript");
  const folder = mkdtempSync(join(tmpdir(), "strainsite-by-hand-"));
  t.after(() => rmSync(folder, { recursive: true }));
  writeFileSync(join(folder, "package.json"), '{"type": "module"}');
  const compilerOptions = { module: ModuleKind.ESNext, target: ScriptTarget.ES2022, rewriteRelativeImportExtensions: true };
  const written = new Set();
  function write(name) {
    if (written.has(name)) return;
    written.add(name);
    const { outputText } = transpileModule(readFileSync(join(WEB, "src", name), "utf8"), { compilerOptions });
    const place = join(folder, name.replace(/\.ts$/, ".js"));
    mkdirSync(dirname(place), { recursive: true });
    writeFileSync(place, outputText);
    for (const [, imported] of outputText.matchAll(/ from "(\..*)\.js"/g)) write(join(dirname(name), `${imported}.ts`));
  }
  return (module) => {
    const name = join("lib/layouts/moving", module);
    write(`${name}.ts`);
    return import(pathToFileURL(join(folder, `${name}.js`)).href);
  };
}

/** Numbers from 0 to 1, the same for a seed (mulberry32). */
function random(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

async function studyOn(service) {
  const send = { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(HAND_STUDY) };
  const { id } = await (await fetch(`${service.url}/v1/studies`, send)).json();
  for (;;) {
    const { state, error } = await (await fetch(`${service.url}/v1/studies/${id}`)).json();
    if (state === "done") return id;
    assert.ok(state === "queued" || state === "running", `${state}: ${error}`);
    await new Promise((resolve) => setTimeout(resolve, 200));
  }
}

/** Films added, dropped and moved by chance, as a reader would. */
function byChance(edits, kinds, chance) {
  const kind = () => kinds[Math.floor(chance() * kinds.length)];
  const angle = () => (chance() < 0.5 ? Math.floor(360 * chance()) : 360 * chance());
  let films = [];
  for (let k = 0; k < 14; k += 1) films = edits.added(films, kind(), 24 * k + 20 * chance());
  for (let step = 0; step < 12; step += 1) {
    const index = Math.floor(chance() * films.length);
    const deed = chance();
    if (deed < 0.3) films = edits.added(films, kind(), angle());
    else if (deed < 0.5) films = edits.dropped(films, index);
    else if (deed < 0.6) films = edits.turnedInto(films, index, kind());
    else films = edits.movedTo(films, index, films[index].theta_deg + 5 * (chance() < 0.5 ? -1 : 1) + (chance() < 0.5 ? 0 : chance()));
  }
  return films;
}

const isEqual = (a, b) => Math.abs(a - b) <= EQUAL * Math.abs(b);

test("the page's bounds of 50 layouts moved by chance are the service's", { timeout: 600_000 }, async (t) => {
  const service = await startService();
  t.after(() => service.stop());
  const id = await studyOn(service);
  const load = pageModules(t);
  const [{ layoutBounds, readyFields }, edits] = [await load("layout-bounds"), await load("moved-films")];
  const fields = await (await fetch(`${service.url}/v1/studies/${id}/layouts/fields`)).json();
  const ready = readyFields(fields);
  const chance = random(7);
  const layouts = Array.from({ length: LAYOUTS }, () => ({ films: byChance(edits, fields.kinds, chance) }));
  const send = { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify({ layouts }) };
  const answer = await fetch(`${service.url}/v1/studies/${id}/layouts:score`, send);
  const scored = await answer.json();
  assert.equal(answer.status, 200, JSON.stringify(scored));
  let [told, largest] = [0, 0];
  scored.layouts.forEach(({ loads }, k) => {
    layoutBounds(ready, layouts[k].films).forEach((own, at) => {
      const { score } = loads[at];
      if ("blind_deg" in own) return assert.match(score.reason, new RegExp(`contact at ${own.blind_deg} degrees`));
      told += 1;
      const pairs = [
        [own.bounds.worst_angle_deg, score.worst_angle_error_deg],
        [own.bounds.rms_angle_deg, score.rms_angle_error_deg],
        [own.bounds.worst_depth_mm, score.worst_depth_error_mm],
      ];
      for (const [a, b] of pairs) {
        largest = Math.max(largest, Math.abs(a / b - 1));
        assert.ok(isEqual(a, b), `layout ${k}, load ${at}: ${a} for ${b}`);
      }
    });
  });
  t.diagnostic(`${told} loads of ${LAYOUTS} layouts have bounds; the largest relative difference is ${largest}`);
  assert.ok(told > LAYOUTS, "most layouts tell the contact");

  const films = Array.from({ length: 24 }, (_, k) => ({ theta_deg: 15 * k + 0.5, phi_deg: 0, angle_deg: 90 }));
  const times = Array.from({ length: 5 }, () => {
    const begun = performance.now();
    layoutBounds(ready, films);
    return performance.now() - begun;
  }).sort((a, b) => a - b);
  t.diagnostic(`bounds of 24 films at ${fields.loads.length} loads take ${times[2].toFixed(1)} ms, median of 5`);
  assert.ok(times[2] < 100);
});
