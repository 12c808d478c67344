// The colours of Oklab's reference, and what is known of those who don't see green.
import assert from "node:assert/strict";
import { test } from "node:test";
import { nearest, oklab } from "./colour-vision.mjs";

const near = (found, wanted) => found.every((value, k) => Math.abs(value - wanted[k]) < 2e-4);

test("white, red and blue are where Oklab's author has them", () => {
  assert.ok(near(oklab([255, 255, 255]), [1, 0, 0]), oklab([255, 255, 255]).join());
  assert.ok(near(oklab([255, 0, 0]), [0.62796, 0.22486, 0.12585]), oklab([255, 0, 0]).join());
  assert.ok(near(oklab([0, 0, 255]), [0.45201, -0.03246, -0.31153]), oklab([0, 0, 255]).join());
});

test("a deuteranope sees grey as it is, and red and green of one lightness nearly alike", () => {
  assert.ok(near(oklab([120, 120, 120], true), oklab([120, 120, 120])));
  const [red, green] = [
    [191, 85, 60],
    [110, 112, 40],
  ];
  const { distance } = nearest([red, green, [0, 0, 255]]);
  const [a, b] = [oklab(red), oklab(green)];
  assert.ok(distance < 0.5 * Math.hypot(...a.map((value, k) => value - b[k])), `${distance}`);
});
