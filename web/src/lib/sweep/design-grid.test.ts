import assert from "node:assert/strict";
import { test } from "node:test";
import { designCount, locateInGrid, readGrid } from "./design-grid.ts";

test("values are JSON or words, and lists stay whole, as on the command line", () => {
  const grid = readGrid('geometry.wall_mm = 2.5, 3\n\n# words\n ground.depths_mm=[1,1,1],[1,2,1]\nmodel.level=draft, "a, b"');
  assert.deepEqual(grid.faults, []);
  assert.deepEqual(
    { ...grid.document },
    {
      "geometry.wall_mm": [2.5, 3],
      "ground.depths_mm": [
        [1, 1, 1],
        [1, 2, 1],
      ],
      "model.level": ["draft", "a, b"],
    },
  );
  assert.equal(designCount(grid), 8);
});

test("every line that can't be read is told with its place", () => {
  const text = "geometry.wall_mm 3\n= 3\na = 1,, 2\nb = 1\nb = 2\nc =";
  const { faults } = readGrid(text);
  assert.deepEqual(
    faults.map((fault) => fault.pointer),
    ["#1", "#2", "#3", "#5", "#6"],
  );
  const span = locateInGrid(text, "#3");
  assert.equal(text.slice(span?.start, span?.end), "a = 1,, 2");
});

test("an empty grid says what one looks like, and makes no design", () => {
  const grid = readGrid("\n# nothing yet\n");
  assert.equal(grid.faults.length, 1);
  assert.equal(designCount(grid), 0);
});

test("a number beyond all numbers stays the word that it is", () => {
  assert.deepEqual(readGrid("a = 1e999").document.a, ["1e999"]);
  assert.deepEqual(Object.entries(readGrid("__proto__ = 1").document), [["__proto__", [1]]]);
});

test("a fault of the service leads to its value, or to its line", () => {
  const text = "geometry.wall_mm = 2.5, -1\ncarcass.angle_deg = 50";
  const place = (pointer: string): string | null => {
    const span = locateInGrid(text, pointer);
    return span === null ? null : text.slice(span.start, span.end);
  };
  assert.equal(place("/grid/geometry.wall_mm/1"), "-1");
  assert.equal(place("/grid/carcass.angle_deg/0"), "50");
  assert.equal(place("/grid/carcass.angle_deg"), "carcass.angle_deg = 50");
  assert.equal(place("/grid/carcass.angle_deg/9"), "carcass.angle_deg = 50");
  for (const pointer of ["", "/grid", "/grid/else/0", "/study/name", "#7"]) assert.equal(place(pointer), null);
  assert.equal(locateInGrid(text, "/grid/carcass.angle_deg/0")?.line, 2);
});
