import assert from "node:assert/strict";
import { test } from "node:test";
import { viewOf } from "./orbit.ts";
import { pixelOf, rayThrough, type Camera } from "./perspective.ts";
import type { Vec3 } from "../surface/skin-geometry.ts";

const camera: Camera = { orbit: viewOf("start", 50), width: 600, height: 400 };

test("the place that is looked at is in the middle", () => {
  const pixel = pixelOf(camera, camera.orbit.target);
  assert.ok(pixel !== null && Math.abs(pixel.x - 300) < 1e-9 && Math.abs(pixel.y - 200) < 1e-9);
});

test("a place along a pixel's line of sight has that pixel", () => {
  for (const [x, y] of [
    [0, 0],
    [599, 20],
    [123.5, 377],
  ] as const) {
    const { origin, direction } = rayThrough(camera, x, y);
    const place = origin.map((value, i) => value + 77 * (direction[i] as number)) as Vec3;
    const pixel = pixelOf(camera, place);
    assert.ok(pixel !== null && Math.abs(pixel.x - x) < 1e-9 && Math.abs(pixel.y - y) < 1e-9);
  }
});

test("from the side the rolling direction is on the right and up is up, and nothing is seen behind the eye", () => {
  const side: Camera = { ...camera, orbit: viewOf("side", 50) };
  assert.ok((pixelOf(side, [10, 0, 0])?.x ?? 0) > 300 && (pixelOf(side, [0, 0, 10])?.y ?? 999) < 200);
  assert.equal(pixelOf(side, [0, -300, 0]), null);
});

test("the whole wheel is in the picture at first, wide or narrow", () => {
  const orbit = viewOf("start", 1);
  const section: [number, number][] = [
    [1, 0],
    [0.75, 0.25],
    [0.75, -0.25],
  ];
  const rim = Array.from({ length: 120 }, (_, k) => (k * Math.PI) / 60).flatMap((angle) =>
    section.map(([radius, across]): Vec3 => [radius * Math.sin(angle), across, -radius * Math.cos(angle)]),
  );
  for (const [width, height] of [
    [533, 440],
    [344, 343],
  ] as const) {
    const pixels = rim.map((place) => pixelOf({ orbit, width, height }, place) ?? { x: -1, y: -1 });
    assert.ok(pixels.every(({ x, y }) => x > 0 && x < width && y > 0 && y < height));
  }
});
