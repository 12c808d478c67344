import assert from "node:assert/strict";
import { test } from "node:test";
import { decades, linear, linearTicks, log, logTicks, percents, places, placeTicks, padded, type Ticks } from "./scales.ts";

const texts = <T>({ values, text }: Ticks<T>): string[] => values.map(text);

test("numbers of an axis are round, and as long as they need to be", () => {
  assert.deepEqual(texts(linearTicks(linear([-12, 12], [0, 100]), 4)), ["−10", "−5", "0", "5", "10"]);
  assert.deepEqual(texts(linearTicks(linear([0, 0.7], [0, 100]), 4)), ["0.0", "0.2", "0.4", "0.6"]);
  assert.deepEqual(texts(linearTicks(linear([9000, 31_000], [0, 100]), 2)), ["10\u202f000", "20\u202f000", "30\u202f000"]);
});

test("a lone value has a scale, too", () => {
  const straight = linear([3, 3], [10, 90]);
  assert.equal(straight(3), 10);
  assert.deepEqual(texts(linearTicks(straight, 2)), ["3.0", "3.5", "4.0"]);
  assert.equal(log([6, 6], [10, 90])(6), 50);
});

test("errors that reach beyond all or nothing are cut", () => {
  const scale = percents([34, 364]);
  assert.deepEqual([-5, 0, 50, 120].map(scale), [34, 34, 199, 364]);
});

test("decades hold all values", () => {
  const ends = (values: number[]) => decades(values, [0, 1]).domain();
  assert.deepEqual(ends([0.2, 43]), [0.1, 100]);
  assert.deepEqual(ends([1, 10]), [1, 10]);
  assert.deepEqual(ends([1]), [1, 10]);
  assert.deepEqual(ends([]), [0.1, 1]);
});

test("logarithmic axes go by 1, 2 and 5, or by powers of ten", () => {
  assert.deepEqual(texts(logTicks(log([0.5, 180], [0, 1]), [1, 2, 5])), ["0.5", "1", "2", "5", "10", "20", "50", "100"]);
  assert.deepEqual(texts(logTicks(log([50, 180], [0, 1]), [1, 2, 5])), ["50", "100"]);
  assert.deepEqual(texts(logTicks(decades([2e-5, 0.3], [0, 1]), [1])), ["1e−5", "0.0001", "0.001", "0.01", "0.1", "1"]);
});

test("names have places of equal breadth, half a gap at the ends", () => {
  const scale = places(["P3", "P1"], [8, 68], 0.5);
  const { values, at } = placeTicks(scale);
  assert.deepEqual(values.map(at), [23, 53]);
  assert.equal(scale.bandwidth(), 15);
});

test("a range holds many values, one, and none", () => {
  assert.deepEqual(padded([0, 100]), [-5, 105]);
  assert.deepEqual(padded([3]), [2, 4]);
  assert.deepEqual(padded([]), [0, 1]);
});
