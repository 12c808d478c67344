import assert from "node:assert/strict";
import { test } from "node:test";
import { contactOutline, groundHeight, sectionOutline } from "./tire-drawing.ts";

const DOCUMENT = {
  scene: {
    geometry: { outer_radius_mm: 50, section_radius_mm: 12.5, wall_mm: 3, bead_angle_deg: 120 },
    carcass: { position: 0.5 },
    ground: { stations: 5, station_spacing_mm: 5.5, station_functions: "bspline", depths_mm: [1, 1, 1, 1, 1] },
  },
  inputs: [{ name: "P3", vary: "ground.depths_mm[2]", distribution: { kind: "uniform", min: 1, max: 3 } }],
};
const nearly = (value: number | undefined, wanted: number): void => assert.ok(Math.abs((value ?? NaN) - wanted) < 1e-9, `${value} is not ${wanted}`);

test("the section's wall is as thick as it says, all around", () => {
  const outline = sectionOutline(DOCUMENT);
  assert.ok(outline !== null);
  const distances = outline.wall.map(([x, z]) => Math.hypot(x, z - 12.5));
  distances.slice(0, distances.length / 2).forEach((distance) => nearly(distance, 12.5));
  distances.slice(distances.length / 2).forEach((distance) => nearly(distance, 9.5));
  outline.cords?.forEach(([x, z]) => nearly(Math.hypot(x, z - 12.5), 11));
  assert.equal(sectionOutline({ scene: { geometry: { section_radius_mm: 3, wall_mm: 3, bead_angle_deg: 90 } } }), null);
  assert.equal(sectionOutline({}), null);
});

test("equal depths are flat ground, far out too, by either function", () => {
  for (const isHat of [true, false]) for (const x of [-40, -11, -3.3, 0, 2, 27]) nearly(groundHeight([1, 1, 1, 1, 1], 5.5, isHat, x), 1);
  nearly(groundHeight([0, 0, 1, 0, 0], 5.5, true, 0), 1);
  nearly(groundHeight([0, 0, 1, 0, 0], 5.5, false, 0), 2 / 3);
  nearly(groundHeight([0, 0, 1, 0, 0], 5.5, false, 5.5), 1 / 6);
  nearly(groundHeight([2, 0, 0, 0, 0], 5.5, false, -50), 2);
});

test("stations stand at their distances, a depth that varies at its mean with its range", () => {
  const outline = contactOutline(DOCUMENT);
  assert.deepEqual(
    outline?.stations.map(({ x_mm }) => x_mm),
    [-11, -5.5, 0, 5.5, 11],
  );
  assert.deepEqual(outline?.stations[2], { name: "P3", x_mm: 0, depth_mm: 2, half_mm: 1 });
  nearly(outline?.tire[60]?.[1], 0);
  nearly(outline?.inner[60]?.[1], 3);
  assert.equal(contactOutline({ scene: { ...DOCUMENT.scene, ground: { load_n: 13 } } }), null);
});
