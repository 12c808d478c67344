// The sheet to glue by: on paper every film is where the answer puts it, to a tenth of a millimetre.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openBrowser, openPage, violations } from "../page.mjs";
import { startService } from "../service.mjs";
import { linesOf } from "./pdf-lines.mjs";

const STUDY_MS = Number(process.env.STRAINSITE_STUDY_MS ?? 600_000);
// Three times the foot tire: a table of two pages, and more strips than a page holds.
const STUDY = {
  name: "to glue",
  scene: {
    preset: "foot-tire",
    geometry: { outer_radius_mm: 150, section_radius_mm: 37.5, wall_mm: 9 },
    ground: { depths_mm: [3, 3, 3, 3, 3] },
  },
  inputs: [{ name: "depth", vary: "ground.depths_mm[2]", distribution: { kind: "uniform", min: 2, max: 4 } }],
  layouts: { depths_mm: [3], units: [48], spacings_deg: [], positions: ["shoulder"], directions: [["x"]] },
  method: { kind: "mdrm", nodes: 3, check_points: 0 },
  accuracy: { preset: "draft" },
};
const [STRIP_MM, CROSS_MM, TOLERANCE_MM] = [180, 4, 0.1];
/** From the paper's edge to the strips: the page's margin, and the template's own. */
const LEFT_MM = 9 + 5;
const near = (value, wanted) => Math.abs(value - wanted) < TOLERANCE_MM;
const lies = ({ from, to }) => near(from[1], to[1]);

test("the sheet prints at true scale, with every film at its arc, on A4 and on Letter", { timeout: STUDY_MS }, async (t) => {
  const service = process.env.STRAINSITE_PAGE === undefined ? await startService() : null;
  t.after(() => service?.stop());
  const url = process.env.STRAINSITE_PAGE ?? service.url;
  const browser = await openBrowser();
  t.after(() => browser.close());
  const { page, complaints } = await openPage(browser, { viewport: { width: 390, height: 844 }, colorScheme: "dark" });
  const sent = await fetch(`${url}/v1/studies`, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(STUDY) });
  const { id } = await sent.json();
  await page.goto(`${url}/#/studies/${id}`);
  await page.getByRole("link", { name: "Sheet to glue by" }).click({ timeout: STUDY_MS });
  await page.waitForURL(/\/sheet$/);
  await page.locator(".template svg").first().waitFor();

  const { films } = (await (await fetch(`${url}/v1/studies/${id}/result`)).json()).answer;
  assert.equal(films.length, 48);
  const rows = await page.$$eval(".sheet tbody tr", (found) => found.map(({ cells }) => [...cells].map((cell) => cell.textContent)));
  assert.deepEqual(
    rows.map(([number]) => Number(number)),
    films.map(({ number }) => number),
  );
  rows.forEach(([number, angle, arc], k) => {
    assert.ok(near(Number(arc), (Number(angle) / 360) * films[k].circle_mm), `film ${number} at ${angle} degrees: ${arc} mm`);
  });
  assert.deepEqual(await violations(page), []);

  await page.evaluate(() => {
    globalThis.print = () => document.body.classList.add("printed");
  });
  await page.getByRole("button", { name: "Print" }).click();
  assert.equal(await page.locator("body.printed").count(), 1);

  // Two of the table; strips are 131 mm high, and Letter has room for two of them but for a millimetre.
  for (const [format, sheets] of [
    ["A4", 5],
    ["Letter", 7],
  ]) {
    const pages = linesOf(await page.pdf({ format, preferCSSPageSize: true }));
    const lines = pages.flat();
    const bars = lines.filter((line) => lies(line) && Math.abs(line.length - 100) < 5);
    t.diagnostic(`${format}: ${pages.length} pages, a bar of ${bars.map(({ length }) => length.toFixed(3))} mm`);
    assert.ok(bars.length === 1 && near(bars[0].length, 100), JSON.stringify(bars));
    assert.equal(pages.length, sheets);
    const crosses = lines.filter((line) => lies(line) && near(line.length, CROSS_MM)).map(({ from, to }) => (from[0] + to[0]) / 2 - LEFT_MM);
    assert.ok(crosses.length >= films.length, `${crosses.length} films are drawn`);
    const missing = films.filter(({ arc_mm }) => !crosses.some((at) => near(at, arc_mm % STRIP_MM)));
    assert.deepEqual(missing, []);
  }
  assert.deepEqual(complaints, []);
});
