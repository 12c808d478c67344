// A Chromium page that keeps what it asked for and what it complained about.
import { chromium } from "playwright-core";

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

export async function openBrowser() {
  return chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: FLAGS });
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
    complaints.push(`${message.type()}: ${message.text()} at ${message.location().url}`);
  });
  return { page, requests, complaints };
}

/** The canvas of the map: how many colours it shows, and a hash of its pixels. */
export function readCanvas(page) {
  return page.$eval("canvas", (canvas) => {
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
