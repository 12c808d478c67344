// The tire in three dimensions beside its map, by software WebGL.
// STRAINSITE_PAGE is the address of a page in front of a service of its own, for those who work on the page.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { openBrowser, openPage, readCanvas, SOFTWARE_WEBGL } from "./page.mjs";
import { startService } from "./service.mjs";

const STUDY_MS = Number(process.env.STRAINSITE_STUDY_MS ?? 600_000);
const FILM_MM = [5, 2];
const PICKS = 200;
/** What three dimensions may add to a page, bytes on the wire. */
const MOST_BYTES = 250_000;

let service;
let browser;
let root;
let study;

before(
  async () => {
    if (process.env.STRAINSITE_PAGE === undefined) service = await startService();
    root = process.env.STRAINSITE_PAGE ?? service.url;
    browser = await openBrowser(SOFTWARE_WEBGL);
    study = await solvedStudy();
  },
  { timeout: STUDY_MS },
);

after(async () => {
  await browser?.close();
  await service?.stop();
});

/** The shipped study at the quickest level, with a small map and films of a size. */
async function solvedStudy() {
  const { studies: presets } = await json("/v1/presets");
  const { document } = presets.find(({ name }) => name === "foot-tire");
  const layouts = { spacings_deg: [60, 90], positions: ["crown"], depths_mm: [1], size_mm: FILM_MM };
  const candidates = { points: "P1-P5", grid: { circumferential: 31, meridional: 11 } };
  const asked = { ...document, name: "the tire's test", accuracy: { preset: "draft" }, layouts, candidates };
  const sent = await fetch(`${root}/v1/studies`, {
    method: "POST",
    body: JSON.stringify(asked),
    headers: { "Content-Type": "application/json" },
  });
  assert.equal(sent.status, 202, await sent.clone().text());
  const { id } = await sent.json();
  for (;;) {
    const { state, error } = await json(`/v1/studies/${id}`);
    if (state === "done") return id;
    assert.ok(state === "queued" || state === "running", `the study ${state}: ${JSON.stringify(error)}`);
    await new Promise((resolve) => setTimeout(resolve, 200));
  }
}

async function json(path) {
  const answer = await fetch(root + path);
  assert.ok(answer.ok, `${path}: ${answer.status}`);
  return answer.json();
}

/** The tire's section, drawn. */
async function openTire(query = "", options = {}) {
  const opened = await openPage(browser, { viewport: { width: 1440, height: 1000 }, reducedMotion: "reduce", ...options });
  await opened.page.goto(`${root}/#/studies/${study}/tire${query}`);
  await opened.page.locator('.wheel canvas[data-drawn="yes"]').waitFor();
  return opened;
}

/** Name, colours and height of the picture that the page offers as a file. */
async function coloursOfPicture(page, button = "PNG") {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: button, exact: true }).click()]);
  const chunks = [];
  for await (const chunk of await download.createReadStream()) chunks.push(chunk);
  const bytes = Buffer.concat(chunks).toString("base64");
  const found = await page.evaluate(async (text) => {
    const binary = Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0));
    const picture = await createImageBitmap(new Blob([binary], { type: "image/png" }));
    const context = new OffscreenCanvas(picture.width, picture.height).getContext("2d");
    context.drawImage(picture, 0, 0);
    const { data } = context.getImageData(0, 0, picture.width, picture.height);
    const found = new Set();
    for (let at = 0; at < data.length; at += 4) found.add((data[at] << 16) | (data[at + 1] << 8) | data[at + 2]);
    return { colours: found.size, height: picture.height };
  }, bytes);
  return { name: download.suggestedFilename(), ...found };
}

test("the tire is drawn, in few bytes, and saved as a picture by name", async (t) => {
  const { page, requests, complaints } = await openTire();
  const saved = await coloursOfPicture(page);
  assert.equal(saved.name, "the-tire-s-test-start.png");
  assert.ok(saved.colours > 200, `the picture has ${saved.colours} colours`);
  // Three pixels for one of the page.
  const heights = await page.evaluate(() => [".wheel", ".legend"].map((part) => 3 * document.querySelector(part).getBoundingClientRect().height));
  assert.ok(saved.height > heights[0] + 0.8 * heights[1], `${saved.height} px have no room for the tire and its legend, ${heights} px`);
  const sizes = await page.evaluate(() =>
    performance
      .getEntriesByType("resource")
      .filter(({ name }) => /wheel-scene|\/surface$/.test(name))
      .map(({ name, transferSize }) => [name, transferSize]),
  );
  const bytes = sizes.reduce((sum, [, size]) => sum + size, 0);
  t.diagnostic(`three dimensions took ${bytes} bytes: ${JSON.stringify(sizes)}`);
  assert.equal(sizes.length, 2, JSON.stringify(sizes));
  // A page under development is sent as it is written.
  if (service !== undefined) assert.ok(bytes > 50_000 && bytes < MOST_BYTES, `${bytes} bytes`);
  assert.ok(
    requests.every((url) => new URL(url.replace(/^blob:/, "")).origin === new URL(root).origin),
    requests.join(" "),
  );
  // Software WebGL says that reading its picture took time.
  assert.deepEqual(
    complaints.filter((text) => !text.includes("GPU stall due to ReadPixels")),
    [],
  );
  await page.context().close();
});

test("the whole tire is within its frame at first, on a phone too", async (t) => {
  for (const viewport of [
    { width: 1440, height: 900 },
    { width: 390, height: 844 },
  ]) {
    const { page } = await openTire("", { viewport });
    await page.waitForTimeout(500);
    const picture = (await page.locator(".wheel canvas").screenshot()).toString("base64");
    const drawn = await page.evaluate(async (text) => {
      const image = await createImageBitmap(new Blob([Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0))], { type: "image/png" }));
      const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
      context.drawImage(image, 0, 0);
      const { data, width, height } = context.getImageData(0, 0, image.width, image.height);
      const colourAt = (x, y) => [...data.subarray(4 * (y * width + x), 4 * (y * width + x) + 3)].join();
      // Beyond the frame's own line and its round corners.
      const [ground, inset] = [colourAt(8, 8), 4];
      let [tire, atEdge] = [0, 0];
      for (let y = inset; y < height - inset; y += 1) {
        for (let x = inset; x < width - inset; x += 1) {
          if (colourAt(x, y) === ground) continue;
          tire += 1;
          if (x === inset || y === inset || x === width - inset - 1 || y === height - inset - 1) atEdge += 1;
        }
      }
      return { share: tire / (width * height), atEdge };
    }, picture);
    t.diagnostic(`${viewport.width} px: the tire takes ${(100 * drawn.share).toFixed(0)} % of its frame`);
    assert.equal(drawn.atEdge, 0, "nothing is cut off");
    assert.ok(drawn.share > 0.25, `${drawn.share}`);
    await page.context().close();
  }
});

test("the map is saved with the colours of its canvas below its lines", async () => {
  const { page, complaints } = await openTire("?quantity=strain");
  const png = await coloursOfPicture(page, "Save map of strain x as PNG");
  assert.equal(png.name, "the-tire-s-test-map-of-strain-x.png");
  assert.ok(png.colours > 200, `the picture has ${png.colours} colours`);
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Save map of strain x as SVG" }).click()]);
  const chunks = [];
  for await (const chunk of await download.createReadStream()) chunks.push(chunk);
  const svg = Buffer.concat(chunks).toString();
  assert.match(svg, /<image [^>]*href="data:image\/png;base64,/);
  assert.match(svg, /mm along the crown/);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("what is picked on the tire is what the service says of that place", { timeout: 120_000 }, async (t) => {
  const { page, complaints } = await openTire("?direction=x&quantity=index&input=P3");
  const maps = await Promise.all(["x", "y"].map((direction) => json(`/v1/studies/${study}/map?direction=${direction}&input=P3`)));
  await page.locator(".wheel").focus();
  await page.keyboard.press("4");
  const box = await page.locator(".wheel").boundingBox();
  const random = generator(20261123);
  let read = 0;
  for (let tries = 0; read < PICKS; tries += 1) {
    assert.ok(tries < 20 * PICKS, `${read} places of ${tries} tries`);
    await page.mouse.move(box.x + 1 + random() * (box.width - 2), box.y + 1 + random() * (box.height - 2));
    const reading = await readTable(page);
    if (reading === null || reading.cells[0][0] === "—") continue;
    read += 1;
    maps.forEach((map, column) => {
      const cell = (row) => reading.cells[row][column];
      near(cell(0), 1e6 * bilinear(map, map.strain, reading), 0.5, "strain", reading);
      near(cell(1), 1e6 * bilinear(map, map.std, reading), 0.5, "deviation", reading);
      const index = bilinear(map, map.first_order, reading);
      const [value, error] = reading.cells[4][column].split(" ± ");
      if (index === null) return assert.equal(cell(4), "—");
      near(value, 100 * index, 0.005, "index", reading);
      const claimed = bilinear(map, map.error, reading);
      if (claimed === null) assert.equal(error, "?");
      else near(error, 100 * claimed, 0.005, "error", reading);
    });
  }
  t.diagnostic(`${read} places read`);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

/** Mulberry32: the same places in every run. */
function generator(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}

function readTable(page) {
  return page.evaluate(
    () =>
      new Promise((resolve) =>
        setTimeout(() => {
          const place = document.querySelector(".readout strong");
          if (place === null) return resolve(null);
          const cells = [...document.querySelectorAll(".point-table tbody tr")].map((row) => [...row.querySelectorAll("td")].map((cell) => cell.textContent));
          resolve({ theta_deg: Number(place.dataset.theta), phi_deg: Number(place.dataset.phi), cells });
        }),
      ),
  );
}

/** The text's number is the value within the rounding of its last digit. */
function near(text, value, half, what, { theta_deg, phi_deg }) {
  const number = Number(text.replaceAll("\u202f", "").replace("−", "-"));
  // Microstrains below 100 have three digits, others none: half a unit covers both. The last bits of both sums may differ.
  assert.ok(Math.abs(number - value) <= half + 1e-6, `${what} ${text} beside ${value} at ${theta_deg}, ${phi_deg}`);
}

/** What the service's grid says between its points; the nearest point's where one of four has no value. */
function bilinear({ theta_deg, phi_deg }, values, at) {
  const [column, row] = [below(theta_deg, at.theta_deg), below(phi_deg, at.phi_deg)];
  const [s, t] = [share(theta_deg, column, at.theta_deg), share(phi_deg, row, at.phi_deg)];
  const corners = [
    [0, 0, (1 - s) * (1 - t)],
    [1, 0, s * (1 - t)],
    [0, 1, (1 - s) * t],
    [1, 1, s * t],
  ]
    .map(([right, up, weight]) => ({ value: values[(row + up) * theta_deg.length + column + right], weight }))
    .filter(({ weight }) => weight > 0);
  if (corners.some(({ value }) => value === null)) return corners.toSorted((a, b) => b.weight - a.weight)[0].value;
  return corners.reduce((sum, { value, weight }) => sum + weight * value, 0);
}

function below(axis, value) {
  return Math.max(
    0,
    Math.min(
      axis.length - 2,
      axis.findLastIndex((each) => each <= value),
    ),
  );
}

function share(axis, at, value) {
  return Math.min(1, Math.max(0, (value - axis[at]) / (axis[at + 1] - axis[at])));
}

test("a layout's films lie at its angles, in their true size, and arrows lead to the others", async () => {
  const { page, complaints } = await openTire();
  const { layouts } = await json(`/v1/studies/${study}/layouts`);
  const { answer } = await json(`/v1/studies/${study}/result?map=false`);
  const chosen = () => page.locator(".layout-choice select").evaluate(({ value }) => value);
  assert.equal(await chosen(), String(layouts.findIndex(({ rank }) => rank === answer.layout.rank)), "the answer's films are there at first");
  await page.locator(".layout-choice select").selectOption({ label: "none" });
  await page.waitForURL(/layout=none/);
  assert.equal(await page.locator(".film-marks polygon").count(), 0);
  const at = layouts.findIndex(({ spacing_deg, films }) => spacing_deg === 60 && films.length === 2);
  await page.locator(".layout-choice select").selectOption(String(at));
  await page.locator(".film-marks polygon").first().waitFor();
  const drawn = await page.evaluate(() => {
    const boxes = [...document.querySelectorAll(".film-marks > polygon")].map((film) => film.getBBox());
    const [centre] = [...document.querySelectorAll(".point-mark g")]
      .filter((mark) => mark.textContent === "P3")
      .map((mark) => mark.querySelector("circle").getBBox());
    const ticks = [...document.querySelector(".map .axis").querySelectorAll("g")].map((tick) => [
      Number(tick.textContent.replace("−", "-")),
      tick.querySelector("line").x1.baseVal.value,
    ]);
    return {
      boxes: boxes.map(({ x, y, width, height }) => ({ x, y, width, height })),
      centre: centre.x + centre.width / 2,
      ticks,
      arrows: document.querySelectorAll(".film-marks > g polygon").length,
    };
  });
  assert.equal(drawn.boxes.length, 2, "of six units one is on the map, with a film of x and one of y");
  assert.equal(drawn.arrows, 2);
  const [[low, left], [high, right]] = [drawn.ticks[0], drawn.ticks[1]];
  const pixels = (right - left) / (high - low);
  const sizes = drawn.boxes.map(({ width, height }) => [width / pixels, height / pixels]);
  for (const { x, width } of drawn.boxes) assert.ok(Math.abs(x + width / 2 - drawn.centre) < 0.2, "the unit at 0 degrees lies on P3");
  const wanted = [FILM_MM, [...FILM_MM].reverse()];
  sizes.flat().forEach((size, k) => assert.ok(Math.abs(size - wanted.flat()[k]) < 0.1, `${sizes.join(" and ")} mm`));
  assert.match(await page.locator(".tire-figures").innerText(), /10 of 12 films lie beyond its arrows, the nearest at 60\.0°/);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("a slider on a solved value shows that solve, and says what lies between", async () => {
  const { page, complaints } = await openTire("?quantity=strain&input=P3");
  const line = await json(`/v1/studies/${study}/sections?input=P3`);
  await page.locator(".map").focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await page.locator(".depth-plot").waitFor();
  assert.equal(await page.locator(".depth-plot circle").count(), line.nodes.length);
  const slider = page.locator(".input-slider input");
  const still = await readCanvas(page);
  const [first, second] = line.nodes;
  await slide(slider, first.value);
  await page.waitForFunction(() => document.querySelector(".slider-words").textContent.startsWith("Solved at"));
  const { cells, ...place } = await readTable(page);
  near(cells[0][0], 1e6 * bilinear(line, first.strain_x, place), 0.5, "strain", place);
  near(cells[0][1], 1e6 * bilinear(line, first.strain_y, place), 0.5, "strain", place);
  await page.waitForTimeout(100);
  assert.notEqual((await readCanvas(page)).hash, still.hash, "the map follows");
  await slide(slider, (first.value + second.value) / 2);
  await page.waitForFunction(() => /interpolated between the solved .* and /.test(document.querySelector(".slider-words").textContent));
  await page.getByRole("button", { name: "At the mean" }).click();
  await page.waitForTimeout(100);
  assert.equal((await readCanvas(page)).hash, still.hash, "at the mean it is as it was");
  assert.deepEqual(complaints, []);
  await page.context().close();
});

function slide(slider, value) {
  return slider.evaluate((input, to) => {
    input.value = String(to);
    input.dispatchEvent(new Event("input", { bubbles: true }));
  }, value);
}

test("keys turn, cut and reset, nothing is drawn while still, and a turn takes a frame", async (t) => {
  const { page, complaints } = await openTire();
  await page.locator(".wheel").evaluate((wheel) => Object.assign(wheel.style, { width: "900px", height: "600px" }));
  await page.locator(".wheel").focus();
  await page.waitForTimeout(300);
  const label = () =>
    page
      .locator(".wheel-label")
      .first()
      .evaluate((each) => each.style.left);
  const start = await label();
  await page.keyboard.press("ArrowRight");
  assert.notEqual(await label(), start, "the picture turns");
  await page.keyboard.press("c");
  await page.locator('button[aria-pressed="false"]').waitFor();
  await page.keyboard.press("r");
  assert.equal(await label(), start, "and is reset");
  // The address follows a moment after the last change.
  await page.waitForTimeout(1200);
  const drawn = await page.evaluate(async () => {
    const ask = window.requestAnimationFrame;
    let asked = 0;
    window.requestAnimationFrame = (step) => {
      asked += 1;
      return ask.call(window, step);
    };
    await new Promise((resolve) => setTimeout(resolve, 1000));
    window.requestAnimationFrame = ask;
    return asked;
  });
  assert.equal(drawn, 0, "frames asked for while nothing changed");
  const times = await frameTimes(page);
  t.diagnostic(`frames of 900 x 600 while turning, ms: median ${times[Math.floor(times.length / 2)].toFixed(1)}, longest ${times.at(-1).toFixed(1)}`);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("what is seen is in the address: a link shows it, and turning adds nothing to the history", async () => {
  const { page, complaints } = await openTire("?direction=y&quantity=std");
  await page.waitForLoadState("networkidle");
  const entries = await page.evaluate(() => {
    window.shifts = 0;
    new PerformanceObserver((list) => list.getEntries().forEach(({ value }) => (window.shifts += value))).observe({ type: "layout-shift" });
    return history.length;
  });
  await page.locator(".wheel").focus();
  await page.keyboard.press("4");
  for (let k = 0; k < 3; k += 1) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("c");
  await page.getByText("Keep this scale").click();
  await page.waitForURL((url) => ["eye=", "cut=no", "scale="].every((part) => url.hash.includes(part)));
  await page.waitForTimeout(100);
  // The labels on the tire move with it.
  const shifts = await page.evaluate(() => window.shifts);
  assert.ok(shifts < 0.001, `writing the address shifts the layout by ${shifts}`);
  await page.locator(".map").click({ position: { x: 200, y: 120 } });
  await page.waitForURL((url) => ["eye=", "cut=no", "scale=", "pin="].every((part) => url.hash.includes(part)));
  assert.equal(await page.evaluate(() => history.length), entries);
  const seen = async () => [await page.locator(".wheel-label").allInnerTexts(), await page.locator(".readout strong").innerText(), await readCanvas(page)];
  await page.mouse.move(0, 0);
  const [hash, before] = [new URL(page.url()).hash, await seen()];
  await page.reload();
  await page.locator('.wheel canvas[data-drawn="yes"]').waitFor();
  await page.locator('button[aria-pressed="false"]').waitFor();
  await page.locator(".wheel-label", { hasText: "pin" }).waitFor();
  assert.deepEqual(await seen(), before);
  assert.equal(new URL(page.url()).hash, hash);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

/** Times between frames while the wheel turns, ascending. */
function frameTimes(page) {
  return page.evaluate(async () => {
    const wheel = document.querySelector(".wheel");
    const times = [];
    let last = performance.now();
    for (let k = 0; k < 60; k += 1) {
      wheel.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight", bubbles: true }));
      await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      const now = performance.now();
      times.push((now - last) / 2);
      last = now;
    }
    return times.slice(5).sort((a, b) => a - b);
  });
}

test("when the graphics card is lost the map stays, with a sentence", async () => {
  const { page, complaints } = await openTire();
  await page.locator(".wheel canvas").evaluate((canvas) => canvas.getContext("webgl2").getExtension("WEBGL_lose_context").loseContext());
  await page.getByText("took the graphics card away").waitFor();
  assert.ok((await readCanvas(page)).colours > 20);
  assert.deepEqual(complaints, []);
  await page.context().close();
});

test("without WebGL there is the map alone, with a sentence", async (t) => {
  const plain = await openBrowser(["--disable-3d-apis"]);
  t.after(() => plain.close());
  const { page, requests, complaints } = await openPage(plain, { viewport: { width: 390, height: 844 } });
  await page.goto(`${root}/#/studies/${study}/tire`);
  await page.getByText("This browser has no WebGL").waitFor();
  assert.ok((await readCanvas(page)).colours > 20);
  assert.ok(!requests.some((url) => url.includes("wheel-scene")), "what can't be used isn't loaded");
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
  assert.ok(overflow <= 0, `the narrow page is ${overflow} px too wide`);
  assert.deepEqual(
    complaints.filter((text) => !/WebGL/.test(text)),
    [],
  );
  await page.context().close();
});
