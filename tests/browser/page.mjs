// A Chromium page that keeps what it asked for and what it complained about.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { chromium } from "playwright-core";

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

const FLAGS = [
  "--headless=new",
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** Draws WebGL by software, as machines without a graphics card do. */
export const SOFTWARE_WEBGL = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

/** A browser. Chromium sometimes crashes as it begins, which says nothing of the page: it is begun once more. */
export async function openBrowser(flags = []) {
  const options = { executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: [...FLAGS, ...flags] };
  try {
    return await chromium.launch(options);
  } catch (error) {
    if (!error.message.includes("signal=SIGSEGV")) throw error;
    console.log("# the browser crashed as it began, and is begun once more");
    return chromium.launch(options);
  }
}

/** A page with `requests` (addresses) and `complaints` (console errors, exceptions, refusals of the policy). */
export async function openPage(browser, options) {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  const requests = [];
  const complaints = [];
  page.on("request", (request) => requests.push(request.url()));
  page.on("pageerror", (error) => complaints.push(`exception: ${error.message}`));
  page.on("console", (message) => {
    if (!["error", "warning"].includes(message.type())) return;
    // A driver without a graphics card, on its own speed when a screenshot is taken.
    if (message.text().includes("GL Driver Message (OpenGL, Performance")) return;
    complaints.push(`${message.type()}: ${message.text()} at ${message.location().url}`);
  });
  return { page, requests, complaints };
}

/** Shows the draft of the new study as `form` or `text`: by the words, which wait until nothing moves; the radio itself lies under them. */
export async function showTab(page, tab) {
  await page.locator(`label:has(input[name="tab"][value="${tab}"])`).click();
  await page.locator(`input[name="tab"][value="${tab}"]:checked`).waitFor({ state: "attached" });
}

/** Shows the draft of the new study as text; the box. */
export async function showText(page) {
  await showTab(page, "text");
  return page.getByLabel("Study document (JSON)");
}

/** The canvas of the map: how many colours it shows, and a hash of its pixels. */
export function readCanvas(page) {
  return page.$eval(".map canvas", (canvas) => {
    // A copy is read, so that the page's own canvas stays as the page uses it.
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
    const colours = new Set();
    let hash = 2166136261;
    for (let at = 0; at < data.length; at += 4) {
      const colour = (data[at] << 16) | (data[at + 1] << 8) | data[at + 2];
      if (data[at + 3] > 0) colours.add(colour);
      hash = Math.imul(hash ^ colour ^ (data[at + 3] << 24), 16777619) >>> 0;
    }
    return { colours: colours.size, hash };
  });
}

/** The texts of the picture that a figure is saved as, in one line: its title, its own and those of its legend. It must be a drawing that a reader of SVG takes. */
export async function savedTexts(page, name) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: `Save ${name} as SVG`, exact: true }).click()]);
  const text = readFileSync(await download.path(), "utf8");
  return page.evaluate((svg) => {
    const drawing = new DOMParser().parseFromString(svg, "image/svg+xml");
    if (drawing.querySelector("parsererror") !== null) throw new Error("the picture can't be read");
    return [...drawing.querySelectorAll("text")].map((each) => each.textContent).join(" ");
  }, text);
}

/** What axe-core finds wrong with the page by all its rules, a line for each rule with the first elements. It is run by the debugger, which the page's policy doesn't bind. */
export async function violations(page) {
  await page.evaluate(AXE);
  const found = await page.evaluate(async () => (await globalThis.axe.run(document)).violations);
  return found.map(
    ({ id, nodes }) =>
      `${id}: ${nodes
        .slice(0, 3)
        .map(({ target, any }) => `${target} ${any[0]?.message ?? ""}`)
        .join("; ")}`,
  );
}

/** How the page is set, in pixels as seen: texts below 11, rows above a height, and how much wider than its window it is. */
export function setting(page, rowHeight) {
  return page.evaluate((limit) => {
    const sizeOf = (element) => {
      const matrix = element.closest("svg") === null ? null : element.getScreenCTM?.();
      return Number.parseFloat(getComputedStyle(element).fontSize) * (matrix == null ? 1 : Math.hypot(matrix.a, matrix.b));
    };
    const hasText = (element) => [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.textContent.trim() !== "");
    const isSeen = (element) => element.getClientRects().length > 0 && element.closest(".hidden") === null;
    const texts = [...document.querySelectorAll("body *")].filter((element) => hasText(element) && isSeen(element));
    const small = texts.filter((element) => sizeOf(element) < 10.99).map((element) => `${sizeOf(element)} px: ${element.textContent.trim().slice(0, 40)}`);
    const rows = [...document.querySelectorAll("tr")].filter((row) => row.getBoundingClientRect().height > limit).map((row) => row.textContent.slice(0, 60));
    return { small, rows, overflow: document.documentElement.scrollWidth - window.innerWidth };
  }, rowHeight);
}

/** Pairs of texts that stand on each other, by more than a pixel, without those that aren't seen. What sticks to an edge lies over the rest on purpose. */
export function overlaps(page) {
  return page.evaluate(() => {
    const texts = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
      const parent = node.parentElement;
      if (node.textContent.trim() === "" || isLeftOut(parent)) continue;
      const range = document.createRange();
      range.selectNodeContents(node);
      const whole = clipOf(parent);
      for (const box of range.getClientRects()) {
        const seen = {
          left: Math.max(box.left, whole.left),
          right: Math.min(box.right, whole.right),
          top: Math.max(box.top, whole.top),
          bottom: Math.min(box.bottom, whole.bottom),
        };
        // Lines stand closer than the boxes of their letters: a sixth of the height at either end is empty.
        const empty = (box.bottom - box.top) / 6;
        seen.top += empty;
        seen.bottom -= empty;
        if (seen.right - seen.left > 1 && seen.bottom - seen.top > 1) texts.push({ node, text: node.textContent.trim().slice(0, 30), ...seen });
      }
    }
    texts.sort((a, b) => a.top - b.top);
    const found = [];
    texts.forEach((one, k) => {
      for (const other of texts.slice(k + 1)) {
        if (other.top > one.bottom - 1) break;
        const across = Math.min(one.right, other.right) - Math.max(one.left, other.left);
        const down = Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top);
        if (one.node !== other.node && across > 1 && down > 1) found.push(`“${one.text}” and “${other.text}”`);
      }
    });
    return found;

    function isLeftOut(element) {
      if (element.closest("script, style, title, option, [aria-hidden=true]:not(svg), .hidden, .skip") !== null) return true;
      for (let at = element; at !== null; at = at.parentElement) if (["sticky", "fixed"].includes(getComputedStyle(at).position)) return true;
      return !element.checkVisibility({ opacityProperty: true, visibilityProperty: true, contentVisibilityAuto: true });
    }

    /** What the boxes around an element that cut or scroll leave to be seen. */
    function clipOf(element) {
      const left = { left: -Infinity, right: Infinity, top: -Infinity, bottom: Infinity };
      for (let at = element; at !== null && at !== document.body; at = at.parentElement) {
        const style = getComputedStyle(at);
        if (style.overflowX === "visible" || at instanceof SVGElement) continue;
        const box = at.getBoundingClientRect();
        left.left = Math.max(left.left, box.left);
        left.right = Math.min(left.right, box.right);
        left.top = Math.max(left.top, box.top);
        left.bottom = Math.min(left.bottom, box.bottom);
      }
      return left;
    }
  });
}
