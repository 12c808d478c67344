// The pictures of the documentation, and with --all every view in both colours at both widths into web/screenshots/: from the real program and the shipped study,
// whose hash stands inside each file.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { crc32 } from "node:zlib";
import { openBrowser, openPage, SOFTWARE_WEBGL } from "./page.mjs";
import { startService } from "./service.mjs";

const DOCUMENT = fileURLToPath(new URL("../../studies/foot-tire.toml", import.meta.url));
const PICTURES = fileURLToPath(new URL("../../docs/pictures/", import.meta.url));
const SCREENSHOTS = fileURLToPath(new URL("../../web/screenshots/", import.meta.url));
const WINDOWS = [{ width: 1440, height: 900 }, { width: 390, height: 844 }];
const SECTIONS = ["answer", "tire", "layouts", "indices", "trade", "run"];
/** Bytes of a PNG before its first chunk, and the length of that one, which says how large the picture is. */
const [SIGNATURE, HEADER] = [8, 25];

/** A PNG with a text in it, under a keyword of the format. */
function withText(png, keyword, text) {
  const data = Buffer.from(`tEXt${keyword}\0${text}`, "latin1");
  const [length, check] = [Buffer.alloc(4), Buffer.alloc(4)];
  length.writeUInt32BE(data.length - 4);
  check.writeUInt32BE(crc32(data));
  return Buffer.concat([png.subarray(0, SIGNATURE + HEADER), length, data, check, png.subarray(SIGNATURE + HEADER)]);
}

/** Runs the shipped study; its identifier and the hash of its document. */
async function run(url) {
  const answer = await fetch(`${url}/v1/studies`, { method: "POST", headers: { "Content-Type": "application/toml" }, body: readFileSync(DOCUMENT) });
  const { id, spec_sha256 } = await answer.json();
  for (let state = ""; state !== "done"; ) {
    if (state === "failed" || state === "cancelled") throw new Error(`the study is ${state}`);
    await new Promise((resolve) => setTimeout(resolve, 500));
    ({ state } = await (await fetch(`${url}/v1/studies/${id}`)).json());
  }
  return { id, spec_sha256 };
}

/** Opens an address, waits until it is drawn, and writes what the window shows, or the whole page. */
async function draw(browser, address, path, options, spec_sha256, fullPage) {
  const { page } = await openPage(browser, options);
  await page.goto(address);
  await page.waitForLoadState("networkidle");
  await page.waitForTimeout(600);
  writeFileSync(path, withText(await page.screenshot({ fullPage }), "Source", `strainsite study ${spec_sha256}`));
  await page.context().close();
  console.log(path);
}

const service = await startService();
const browser = await openBrowser(SOFTWARE_WEBGL);
try {
  const { id, spec_sha256 } = await run(service.url);
  const study = `${service.url}/#/studies/${id}`;
  mkdirSync(PICTURES, { recursive: true });
  const wide = { viewport: { width: 1100, height: 640 }, colorScheme: "light" };
  await draw(browser, study, `${PICTURES}answer.png`, wide, spec_sha256, false);
  await draw(browser, `${study}/tire`, `${PICTURES}tire.png`, { viewport: WINDOWS[0], colorScheme: "light" }, spec_sha256, false);
  if (process.argv.includes("--all")) {
    mkdirSync(SCREENSHOTS, { recursive: true });
    const views = [...SECTIONS.map((section) => [section, `${study}/${section}`]), ["new-study", `${service.url}/#/`], ["operations", `${service.url}/docs`]];
    for (const viewport of WINDOWS) {
      for (const colorScheme of ["light", "dark"]) {
        for (const [name, address] of views) {
          await draw(browser, address, `${SCREENSHOTS}${name}-${viewport.width}-${colorScheme}.png`, { viewport, colorScheme }, spec_sha256, name !== "operations");
        }
      }
    }
  }
} finally {
  await browser.close();
  await service.stop();
}
