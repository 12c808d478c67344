// The first screen of an answer among 40 studies of long names: the sentence that answers the question, the trade of films against errors, few words, colours that
// can be told apart.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { openBrowser, openPage, overlaps, setting, violations } from "../page.mjs";
import { startService } from "../service.mjs";
import { nearest } from "./colour-vision.mjs";

const STUDIES = 40;
const STUDY_MS = 300_000;
const WINDOWS = [
  { width: 1440, height: 900 },
  { width: 1280, height: 800 },
  { width: 390, height: 844 },
];
/** Words and figures of the answer on the first screen. */
const MOST_WORDS = 90;
/** Colours of curves, and how far apart they look in Oklab. */
const [PLACES, APART] = [6, 0.15];
const depth = (station) => ({ name: `P${station + 1}`, vary: `ground.depths_mm[${station}]`, distribution: { kind: "uniform", min: 0.7, max: 1.3 } });
const STUDY = {
  scene: { preset: "foot-tire" },
  inputs: [0, 1, 2, 3, 4].map(depth),
  layouts: { spacings_deg: [30, 60, 90], positions: ["crown", "shoulder", "sidewall"], depths_mm: [1, 2] },
  method: { kind: "mdrm", nodes: 3 },
  accuracy: { preset: "draft" },
  question: { angle_deg: 15 },
};
const nameOf = (number) => `${number}: wall of 2.5 mm with two plies of cord at 48 degrees, inflated to 0.02 MPa, five depths below the crown`;

let service;
let browser;
let id;

before(
  async () => {
    service = await startService();
    browser = await openBrowser();
    id = await submit(1);
    for (let state = ""; state !== "done"; ) {
      assert.notEqual(state, "failed");
      await new Promise((resolve) => setTimeout(resolve, 200));
      ({ state } = await (await fetch(`${service.url}/v1/studies/${id}`)).json());
    }
    // Those that were cancelled fill the list as well.
    for (let number = 2; number <= STUDIES; number += 1) await fetch(`${service.url}/v1/studies/${await submit(number)}`, { method: "DELETE" });
  },
  { timeout: STUDY_MS },
);

after(async () => {
  await browser?.close();
  await service?.stop();
});

async function submit(number) {
  const body = JSON.stringify({ ...STUDY, name: nameOf(number) });
  const answer = await fetch(`${service.url}/v1/studies`, { method: "POST", headers: { "Content-Type": "application/json" }, body });
  assert.equal(answer.status, 202, await answer.clone().text());
  return (await answer.json()).id;
}

/** Words and figures below an element that are within the window. */
function wordsIn(page, selector) {
  return page.locator(selector).evaluate((root) => {
    const words = [];
    const range = document.createRange();
    const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
      if (node.parentElement.closest("title, .hidden, .skip, option") !== null || !node.parentElement.checkVisibility({ contentVisibilityAuto: true }))
        continue;
      for (const { 0: word, index } of node.data.matchAll(/\S+/g)) {
        range.setStart(node, index);
        range.setEnd(node, index + word.length);
        const { top, bottom, height } = range.getBoundingClientRect();
        if (height > 0 && top >= 0 && bottom <= window.innerHeight) words.push(word);
      }
    }
    return words;
  });
}

/** Shows the page in this scheme, once it has taken it. */
async function showIn(page, colorScheme) {
  await page.emulateMedia({ colorScheme });
  await page.waitForFunction((isDark) => document.documentElement.classList.contains("theme-dark") === isDark, colorScheme === "dark");
}

/** What the curves' classes draw, three bytes each. */
function curveColours(page) {
  return page.evaluate((count) => {
    const drawing = document.body.appendChild(document.createElementNS("http://www.w3.org/2000/svg", "svg"));
    const colours = Array.from({ length: count }, (_, place) => {
      const curve = drawing.appendChild(document.createElementNS("http://www.w3.org/2000/svg", "path"));
      curve.setAttribute("class", `layout-curve place-${place}`);
      return getComputedStyle(curve).stroke.match(/\d+/g).map(Number);
    });
    drawing.remove();
    return colours;
  }, PLACES);
}

test("among 40 studies the answer comes first, its trade without scrolling, in few words and colours for all", { timeout: 60_000 }, async (t) => {
  const { page, complaints } = await openPage(browser, { viewport: WINDOWS[0] });
  await page.goto(`${service.url}/#/studies/${id}`);
  await page.locator("#section").waitFor();
  await page.locator(".study-list li").nth(15).waitFor();
  const { answer } = await (await fetch(`${service.url}/v1/studies/${id}/result?map=false`)).json();
  assert.match(await page.locator(".answer").innerText(), new RegExp(`^(Answer\\s+)?15° need ${answer.layout.film_count} films: glue them `));
  for (const viewport of WINDOWS) {
    await page.setViewportSize(viewport);
    const { y, height } = await page.locator(".answer .trade-plot").boundingBox();
    assert.ok(y >= 0 && y + height <= viewport.height, `the trade ends at ${y + height} px of ${viewport.height}`);
    const words = await wordsIn(page, ".answer");
    t.diagnostic(
      `${viewport.width} px: ${words.length} words of the answer, ${(await wordsIn(page, ".sidebar")).length} of the lists; the trade ends at ${y + height} px`,
    );
    assert.ok(words.length <= MOST_WORDS, `${words.length} words: ${words.join(" ")}`);
    const { small, overflow } = await setting(page, 1e9);
    assert.deepEqual(small, [], "texts below 11 px");
    assert.ok(overflow <= 0, `the page is ${overflow} px wider than its window`);
    assert.deepEqual(await overlaps(page), [], "texts on each other");
    for (const colorScheme of ["light", "dark"]) {
      await showIn(page, colorScheme);
      assert.deepEqual(await violations(page), [], `${viewport.width} px, ${colorScheme}`);
    }
  }
  for (const colorScheme of ["light", "dark"]) {
    await showIn(page, colorScheme);
    const { pair, distance } = nearest(await curveColours(page));
    t.diagnostic(`${colorScheme}: ${distance.toFixed(3)} between ${pair.join(" and ")}`);
    assert.ok(distance >= APART, `${distance} between ${pair.join(" and ")}, ${colorScheme}`);
  }
  assert.deepEqual(complaints, []);
  await page.context().close();
});
