import assert from "node:assert/strict";
import { test } from "node:test";
import { contrast, css, diverging, inkOn, oklabOfRgb, rgbOfOklab, sequential, type Rgb } from "./colour.ts";

const shares = Array.from({ length: 33 }, (_, index) => index / 32);
const distance = (from: Rgb, to: Rgb): number => {
  const [p, q] = [oklabOfRgb(from), oklabOfRgb(to)];
  return Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
};

test("Oklab puts white at lightness one without colour and comes back to the byte", () => {
  const white = oklabOfRgb([255, 255, 255]);
  // The published matrices carry ten digits and map white to within 1e-7 of (1, 0, 0).
  assert.ok(Math.abs(white[0] - 1) < 1e-6 && Math.hypot(white[1], white[2]) < 1e-6);
  for (const colour of [
    [12, 200, 77],
    [255, 0, 0],
    [3, 3, 250],
  ] as const) {
    assert.deepEqual(rgbOfOklab(oklabOfRgb(colour)), colour);
  }
});

test("the sequential map grows lighter all the way", () => {
  const lightness = shares.map((share) => oklabOfRgb(sequential(share))[0]);
  lightness.slice(1).forEach((value, index) => assert.ok(value > (lightness[index] as number)));
});

for (const [name, map] of [
  ["sequential", sequential],
  ["diverging", diverging],
] as const) {
  test(`equal steps of the ${name} map look equal`, () => {
    const steps = shares.slice(1).map((share, index) => distance(map(shares[index] as number), map(share)));
    // Bytes round by half a unit (about 0.002 of lightness) and clipping to the gamut bends the ends a little.
    const mean = steps.reduce((sum, step) => sum + step, 0) / steps.length;
    steps.forEach((step) => assert.ok(Math.abs(step / mean - 1) < 0.35, `${step} beside a mean of ${mean}`));
  });
}

test("the diverging map is lightest in the middle and as light on both sides", () => {
  const lightness = (share: number): number => oklabOfRgb(diverging(share))[0];
  assert.ok(lightness(0.5) > 0.94);
  // Half a byte of rounding on each side, and one table step.
  for (const side of [0.1, 0.3, 0.5]) assert.ok(Math.abs(lightness(0.5 - side) - lightness(0.5 + side)) < 0.02);
});

test("values outside the scale and missing ones take an end of the map", () => {
  assert.deepEqual(sequential(7), sequential(1));
  assert.deepEqual(sequential(Number.NaN), sequential(0));
  assert.equal(css([1, 2, 3]), "rgb(1 2 3)");
});

test("ink is read on every colour of the maps", () => {
  assert.equal(contrast([0, 0, 0], [255, 255, 255]), 21);
  for (const share of shares) {
    for (const ground of [sequential(share), diverging(share)]) assert.ok(contrast(ground, inkOn(ground)) >= 4.5, css(ground));
  }
});
