import assert from "node:assert/strict";
import { test } from "node:test";
import { ago, bytes, duration, fixed, integer, microstrain, MISSING, moment, percent, rankWords, signed, significant } from "./format.ts";

test("numbers that do not exist are a dash", () => {
  for (const value of [null, undefined, Number.NaN, Number.POSITIVE_INFINITY]) {
    assert.equal(fixed(value, 2), MISSING);
    assert.equal(significant(value), MISSING);
    assert.equal(percent(value), MISSING);
    assert.equal(microstrain(value), MISSING);
    assert.equal(duration(value), MISSING);
    assert.equal(bytes(value), MISSING);
  }
});

test("decimals are fixed, the minus is a minus, and zero has no sign", () => {
  assert.equal(fixed(29.97333, 2), "29.97");
  assert.equal(fixed(-0.5, 1), "−0.5");
  assert.equal(fixed(-0.001, 2), "0.00");
});

test("a difference has its sign, and a missing one is a dash", () => {
  assert.equal(signed(3.554, 2), "+3.55");
  assert.equal(signed(-2.05, 2), "−2.05");
  assert.equal(signed(-0.001, 2), "+0.00");
  assert.equal(signed(null, 2), MISSING);
});

test("significant digits avoid exponents while they can", () => {
  assert.equal(significant(0.012345), "0.0123");
  assert.equal(significant(123456), "123\u202f456");
  assert.equal(significant(1.5e-7), "1.50e−7");
  assert.equal(significant(0), "0");
});

test("strain is shown in microstrain", () => {
  assert.equal(microstrain(0.0882), "88\u202f200");
  assert.equal(microstrain(-2.5e-5), "−25.0");
});

test("shares become percent", () => {
  assert.equal(percent(0.30184), "30.18");
  assert.equal(percent(1, 0), "100");
});

test("durations read like a clock", () => {
  assert.equal(duration(0.42), "0.4 s");
  assert.equal(duration(59.7), "1 min 0 s");
  assert.equal(duration(200), "3 min 20 s");
  assert.equal(duration(7500), "2 h 05 min");
  assert.equal(duration(-1), MISSING);
});

test("bytes and counts carry readable units", () => {
  assert.equal(bytes(512), "512 B");
  assert.equal(bytes(412_000_000), "412 MB");
  assert.equal(integer(23429), "23\u202f429");
});

test("a moment today is a time, an older one has its date", () => {
  const now = new Date(2026, 4, 2, 12, 0);
  assert.equal(moment(new Date(2026, 4, 2, 9, 5).toISOString(), now), "09:05");
  assert.equal(moment(new Date(2026, 4, 1, 9, 5).toISOString(), now), "2026-05-01 09:05");
  assert.equal(moment("no time", now), MISSING);
});

test("a shared rank says so", () => {
  const all = [1, 2, 2, 4].map((rank) => ({ rank }));
  assert.deepEqual(
    all.map(({ rank }) => rankWords(rank, all)),
    ["1", "2=", "2=", "4"],
  );
});

test("a moment is as long ago as one unit can say", () => {
  const now = new Date("2026-11-23T12:00:00Z");
  const words = ["2026-11-23T11:59:30Z", "2026-11-23T11:55:00Z", "2026-11-23T09:00:00Z", "2026-11-22T11:00:00Z", "2026-11-13T12:00:00Z", "soon", null];
  assert.deepEqual(
    words.map((text) => ago(text, now)),
    ["just now", "5 min ago", "3 h ago", "yesterday", "10 days ago", "—", "—"],
  );
});
