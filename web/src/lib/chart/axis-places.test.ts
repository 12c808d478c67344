import assert from "node:assert/strict";
import { test } from "node:test";
import { lineAt, numberAt, titleAt } from "./axis-places.ts";
import { across, frameOf, upwards } from "./frame.ts";

const FRAME = frameOf(200, 100, { left: 40, right: 20, top: 10, bottom: 30 });

test("scales go across the frame, and up it", () => {
  assert.deepEqual(
    [across(FRAME), upwards(FRAME)],
    [
      [40, 180],
      [70, 10],
    ],
  );
});

test("lines go through the chart, or stand outside of it", () => {
  assert.deepEqual(lineAt("left", FRAME, 50, "through"), { x1: 40, x2: 180, y1: 50, y2: 50 });
  assert.deepEqual(lineAt("bottom", FRAME, 50, "short"), { x1: 50, x2: 50, y1: 70, y2: 74 });
  assert.deepEqual(lineAt("top", FRAME, 50, "short"), { x1: 50, x2: 50, y1: 10, y2: 6 });
  assert.deepEqual(lineAt("left", { ...FRAME, left: 0, right: "100%" }, 50, "through"), { x1: 0, x2: "100%", y1: 50, y2: 50 });
});

test("numbers stand outside of the chart, further where lines do", () => {
  assert.deepEqual(numberAt("left", FRAME, 50, "through"), { x: 34, y: 54, "text-anchor": "end" });
  assert.deepEqual(numberAt("right", FRAME, 50, "none"), { x: 186, y: 54, "text-anchor": "start" });
  assert.deepEqual(numberAt("top", FRAME, 50, "short"), { x: 50, y: 0, "text-anchor": "middle" });
  assert.deepEqual(numberAt("bottom", FRAME, "12.5%", "none"), { x: "12.5%", y: 85, "text-anchor": "middle" });
});

test("a title runs along its axis, or stands at an end of it", () => {
  assert.deepEqual(titleAt("left", FRAME, "middle"), { transform: "translate(12 40) rotate(-90)", "text-anchor": "middle" });
  assert.deepEqual(titleAt("right", FRAME, "start"), { x: 194, y: 94, "text-anchor": "end" });
  assert.deepEqual(titleAt("left", FRAME, "end"), { x: 6, y: 0, "text-anchor": "start" });
  assert.deepEqual(titleAt("bottom", FRAME, "middle"), { x: 110, y: 94, "text-anchor": "middle" });
  assert.deepEqual(titleAt("top", FRAME, "start"), { x: 40, y: 12, "text-anchor": "start" });
});
