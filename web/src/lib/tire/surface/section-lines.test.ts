import assert from "node:assert/strict";
import { test } from "node:test";
import type { SectionNode, Sections } from "../../../wire.ts";
import { movedSurface, nodesAbout, strainAt, strainOver, unitOf } from "./section-lines.ts";
import { surfaceBytes } from "./made-up-surface.ts";
import { placeOn } from "./skin-geometry.ts";
import { readSurface } from "./surface-reader.ts";

const node = (value: number, cut_point: boolean, scale: number, raised_mm: number): SectionNode => ({
  value,
  ordinal: 0,
  cut_point,
  reaction_n: 10 * value,
  strain_x: [scale, scale, 3 * scale, 3 * scale],
  strain_y: [0, 0, 0, 0],
  displacement_mm: Array.from({ length: 4 }, () => [0, 0, raised_mm]),
});
const line: Sections = {
  input: "P3",
  vary: "ground.depths_mm[2]",
  theta_deg: [-45, 45],
  phi_deg: [-120, 120],
  inflated_mm: [],
  failed: [],
  nodes: [node(0.8, false, 0.01, 1), node(1, true, 0.02, 2), node(1.4, false, 0.04, 5)],
};
const about = (value: number) => {
  const found = nodesAbout(line, value);
  assert.ok(found);
  return found;
};

test("a solved value is that solve, to the bit", () => {
  assert.deepEqual([about(1).share, about(1.002).low.value, about(1.002).share], [0, 1, 0]);
  assert.deepEqual(strainAt(about(1), "x"), line.nodes[1]?.strain_x);
  assert.deepEqual([about(0).low.value, about(9).low.value], [0.8, 1.4]);
});

test("between two solved values both count", () => {
  const between = about(1.1);
  assert.deepEqual([between.low.value, between.high.value], [1, 1.4]);
  assert.ok(Math.abs(between.share - 0.25) < 1e-12);
  assert.ok(Math.abs((strainAt(between, "x")[0] ?? 0) - 0.025) < 1e-12);
  assert.equal(nodesAbout({ nodes: [] }, 1), null);
});

test("the strain of a place is given at each solved value", () => {
  const plot = strainOver(line, { theta_deg: 0, phi_deg: 0 }, "x");
  assert.deepEqual(
    plot.map(({ value }) => value),
    [0.8, 1, 1.4],
  );
  assert.ok(Math.abs((plot[1]?.strain ?? 0) - 0.04) < 1e-12);
  assert.deepEqual(strainOver(line, { theta_deg: 90, phi_deg: 0 }, "x"), []);
});

test("the surface moves within the map by the difference to the means, and not beyond", () => {
  const wheel = readSurface(surfaceBytes(72, 13));
  const moved = movedSurface(wheel, line, about(1.4));
  assert.ok(moved);
  const rise = (theta_deg: number): number => {
    const at = { theta_deg, phi_deg: 0 };
    const [before, after] = [placeOn(wheel, wheel.inner.displacement, at), placeOn(moved, moved.inner.displacement, at)];
    return (after?.[2] ?? NaN) - (before?.[2] ?? NaN);
  };
  assert.deepEqual([rise(0), rise(40), rise(90)], [3, 3, 0]);
  assert.deepEqual(movedSurface(wheel, line, about(1))?.inner.displacement, wheel.inner.displacement);
  const unknown = { ...line, nodes: line.nodes.filter((each) => !each.cut_point) };
  assert.equal(movedSurface(wheel, unknown, about(1)), null);
});

test("units are read off the field's name", () => {
  assert.deepEqual(["ground.depths_mm[2]", "pressure.internal_mpa", "contact.friction"].map(unitOf), ["mm", "MPa", ""]);
});
