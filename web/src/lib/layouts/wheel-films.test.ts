import assert from "node:assert/strict";
import { test } from "node:test";
import type { RankedLayout } from "../../wire.ts";
import { apartOf, filmsOf, filmsOnSheet, innerRadius, onWheel, shapeOf } from "./wheel-films.ts";

function layout(change: Partial<RankedLayout> = {}): RankedLayout {
  return { rank: 1, spacing_deg: 180, units: 2, position: "crown", films: ["x", "y"], film_count: 4, loads: [], score: { noise_strain: 1e-3 }, ...change };
}

test("a film of each direction in every unit", () => {
  const places = filmsOf(layout({ position: "shoulder" })).map(({ theta_deg, section_deg, angle_deg }) => [theta_deg, section_deg, angle_deg]);
  assert.deepEqual(places, [
    [0, 45, 0],
    [0, 45, 90],
    [180, 45, 0],
    [180, 45, 90],
  ]);
});

test("films of a sheet keep their places, with directions as angles", () => {
  const film = { number: 1, arc_mm: 10, circle_mm: 238, from_bead_mm: 19, from_crown_mm: 0 };
  const placed = filmsOnSheet([
    { ...film, theta_deg: 15, phi_deg: 0, direction: "y" },
    { ...film, theta_deg: 30, phi_deg: 45, direction: "30" },
  ]);
  assert.deepEqual(placed, [
    { theta_deg: 15, section_deg: 0, angle_deg: 90 },
    { theta_deg: 30, section_deg: 45, angle_deg: 30 },
  ]);
});

test("staggered films stand between two units", () => {
  assert.deepEqual(
    filmsOf(layout({ staggered: true })).map(({ theta_deg }) => theta_deg),
    [0, 90, 180, 270],
  );
});

test("a position may be an angle, a direction too; one without an angle has no place", () => {
  assert.deepEqual(filmsOf(layout({ position: "30 deg", films: ["45"], units: 1 })), [{ theta_deg: 0, section_deg: 30, angle_deg: 45 }]);
  assert.deepEqual(filmsOf(layout({ position: "mixed" })), []);
});

test("films that were listed one by one", () => {
  const places = [{ theta_deg: 30, phi_deg: 45, angle_deg: 90 }];
  assert.deepEqual(filmsOf(layout({ spacing_deg: null, places })), [{ theta_deg: 30, section_deg: 45, angle_deg: 90 }]);
});

test("the wheel turns below the films", () => {
  assert.equal(apartOf({ theta_deg: 10 }, 30), -20);
  assert.equal(apartOf({ theta_deg: 350 }, -20), 10);
  assert.equal(apartOf({ theta_deg: 180 }, 0), -180);
});

test("the shape comes from the document, what it doesn't say from the reference tire", () => {
  const shape = shapeOf({ scene: { geometry: { kind: "tire", wall_mm: 5 } } });
  assert.deepEqual(shape, { outer_mm: 50, section_mm: 12.5, wall_mm: 5, bead_deg: 120 });
  assert.deepEqual(shapeOf({}).wall_mm, 3);
  assert.equal(innerRadius(shape, 0), 45);
  assert.ok(Math.abs(innerRadius(shape, 90) - 37.5) < 1e-12);
});

test("the contact is below", () => {
  assert.deepEqual(onWheel(50, 0), { x: 0, y: 50 });
  assert.ok(Math.abs(onWheel(50, 90).x - 50) < 1e-12);
});
