// The pictures of the documentation, and with --all every view and state in both colours at both widths into web/screenshots/: from the real program and the shipped
// study, whose hash stands inside each file.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { crc32 } from "node:zlib";
import { openBrowser, openPage, SOFTWARE_WEBGL } from "./page.mjs";
import { startService } from "./service.mjs";

const DOCUMENT = fileURLToPath(new URL("../../studies/foot-tire.toml", import.meta.url));
const PICTURES = fileURLToPath(new URL("../../docs/pictures/", import.meta.url));
const SCREENSHOTS = fileURLToPath(new URL("../../web/screenshots/", import.meta.url));
const WINDOWS = [
  { width: 1440, height: 900 },
  { width: 390, height: 844 },
];
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

async function send(url, kind, body, type = "application/json") {
  const answer = await fetch(`${url}/v1/${kind}`, { method: "POST", headers: { "Content-Type": type }, body });
  if (answer.status !== 202) throw new Error(await answer.text());
  return answer.json();
}

/** Waits for the end of a study or a sweep. */
async function ended(address) {
  for (;;) {
    const found = await (await fetch(address)).json();
    if (!["queued", "running"].includes(found.state)) return found;
    await new Promise((resolve) => setTimeout(resolve, 500));
  }
}

/** Runs the shipped study; its identifier and the hash of its document. */
async function run(url) {
  const { id, spec_sha256 } = await send(url, "studies", readFileSync(DOCUMENT), "application/toml");
  const { state } = await ended(`${url}/v1/studies/${id}`);
  if (state !== "done") throw new Error(`the study is ${state}`);
  return { id, spec_sha256 };
}

const drafted = (more) => ({
  scene: { preset: "foot-tire" },
  inputs: [{ name: "depth", vary: "ground.depths_mm[2]", distribution: { kind: "uniform", min: 0.7, max: 1.3 } }],
  candidates: { points: "P1-P5", grid: { circumferential: 21, meridional: 9 } },
  layouts: { spacings_deg: [60, 90], positions: ["crown"], depths_mm: [1] },
  method: { kind: "mdrm", nodes: 3 },
  ...more,
});

/** Each picture at both widths in both colours. */
async function drawAll(browser, views, spec_sha256) {
  for (const viewport of WINDOWS) {
    for (const colorScheme of ["light", "dark"]) {
      for (const [name, address] of views) {
        await draw(
          browser,
          address,
          `${SCREENSHOTS}${name}-${viewport.width}-${colorScheme}.png`,
          { viewport, colorScheme },
          spec_sha256,
          name !== "operations",
        );
      }
    }
  }
}

/** What isn't one finished study: a sweep, a comparison, studies that failed, were cancelled, run, or lost their service, which is killed for it. */
async function drawStates(browser, service, spec_sha256) {
  const study = drafted({ name: "textile", accuracy: { preset: "draft" } });
  const { id: sweep } = await send(service.url, "sweeps", JSON.stringify({ study, grid: { "carcass.stiffness_n_per_mm": [1, 50, 100] } }));
  const { designs } = await ended(`${service.url}/v1/sweeps/${sweep}`);
  const of = (state) => designs.filter((design) => design.study.state === state).map((design) => design.study.id);
  const long = drafted({ name: "minutes long", accuracy: { preset: "reference" }, method: { kind: "saltelli", samples: 512 } });
  const { id: cancelled } = await send(service.url, "studies", JSON.stringify(long));
  await fetch(`${service.url}/v1/studies/${cancelled}`, { method: "DELETE" });
  const { id: running } = await send(service.url, "studies", JSON.stringify(long));
  const studies = `${service.url}/#/studies`;
  const views = [
    ["sweep", `${service.url}/#/sweeps/${sweep}`],
    ["compare", `${service.url}/#/compare?studies=${of("done").join(",")}`],
    ["failed", `${studies}/${of("failed")[0]}`],
    ["cancelled", `${studies}/${cancelled}`],
    ["running", `${studies}/${running}`],
  ];
  await drawAll(browser, views, spec_sha256);
  const { page } = await openPage(browser, { viewport: WINDOWS[0] });
  await page.goto(`${studies}/${running}`);
  await page.locator(".badge-running").first().waitFor();
  await service.kill();
  await page.getByText("The service hasn't answered since").waitFor();
  for (const viewport of WINDOWS) {
    for (const colorScheme of ["light", "dark"]) {
      await page.setViewportSize(viewport);
      await page.emulateMedia({ colorScheme });
      await save(page, `${SCREENSHOTS}service-gone-${viewport.width}-${colorScheme}.png`, spec_sha256, true);
    }
  }
}

/** Opens an address, waits until it is drawn, and writes what the window shows, or the whole page. */
async function draw(browser, address, path, options, spec_sha256, fullPage) {
  const { page } = await openPage(browser, options);
  await page.goto(address);
  // A study that runs is never idle: its events are a stream.
  await Promise.race([page.waitForLoadState("networkidle"), page.waitForTimeout(3000)]);
  await page.waitForTimeout(600);
  await save(page, path, spec_sha256, fullPage);
  await page.context().close();
}

async function save(page, path, spec_sha256, fullPage) {
  writeFileSync(path, withText(await page.screenshot({ fullPage }), "Source", `strainsite study ${spec_sha256}`));
  console.log(path);
}

const service = await startService();
const browser = await openBrowser(SOFTWARE_WEBGL);
const isAll = process.argv.includes("--all");
try {
  if (isAll) {
    mkdirSync(SCREENSHOTS, { recursive: true });
    await drawAll(browser, [["empty", `${service.url}/#/`]], "none");
  }
  const { id, spec_sha256 } = await run(service.url);
  const study = `${service.url}/#/studies/${id}`;
  mkdirSync(PICTURES, { recursive: true });
  const wide = { viewport: { width: 1100, height: 640 }, colorScheme: "light" };
  await draw(browser, study, `${PICTURES}answer.png`, wide, spec_sha256, false);
  await draw(browser, `${study}/tire`, `${PICTURES}tire.png`, { viewport: WINDOWS[0], colorScheme: "light" }, spec_sha256, false);
  if (isAll) {
    const views = [...SECTIONS.map((section) => [section, `${study}/${section}`]), ["new-study", `${service.url}/#/`], ["operations", `${service.url}/docs`]];
    await drawAll(browser, views, spec_sha256);
    await drawStates(browser, service, spec_sha256);
  }
} finally {
  await browser.close();
  await service.stop();
}
