import assert from "node:assert/strict";
import { test } from "node:test";
import { oklabOfRgb, sequential } from "../../chart/colour.ts";
import { faded, GREY, trustOf, type Evidence } from "./trust.ts";

const evidence = (change: Partial<Evidence>): Evidence => ({ value: 0.01, error: 0.001, deviation: 0.01, noise: 0.002, ...change });

test("a strain or a deviation below the films' noise is grey, and full from twice the noise on", () => {
  for (const quantity of ["strain", "std"] as const) {
    assert.equal(trustOf(quantity, evidence({ value: 0.002 })), 0);
    assert.equal(trustOf(quantity, evidence({ value: 0.003 })), 0.5);
    assert.equal(trustOf(quantity, evidence({ value: 0.004 })), 1);
  }
  assert.equal(trustOf("strain", evidence({ value: -0.01 })), 1);
});

test("an index is grey where its error exceeds it, and where the strain varies by less than the noise", () => {
  assert.equal(trustOf("index", evidence({ value: 0.3, error: 0.3 })), 0);
  assert.equal(trustOf("index", evidence({ value: 0.3, error: 0.2 })), 0.3 / 0.2 - 1);
  assert.equal(trustOf("index", evidence({ value: 0.3, error: 0.01 })), 1);
  assert.equal(trustOf("index", evidence({ value: 0.9, error: 0.01, deviation: 0.001 })), 0);
  assert.equal(trustOf("total", evidence({ value: 0.9, error: 0.01, deviation: null })), 0);
});

test("what isn't known takes no colour away, and no value is grey", () => {
  assert.equal(trustOf("index", evidence({ error: null, noise: null })), 1);
  assert.equal(trustOf("std", evidence({ value: null })), 0);
});

test("colour fades to grey all the way", () => {
  const chroma = (trust: number): number => {
    const [, a, b] = oklabOfRgb(faded(sequential(0.1), trust));
    return Math.hypot(a, b);
  };
  assert.deepEqual(faded(sequential(0.1), 0), GREY);
  assert.deepEqual(faded(sequential(0.1), 1), sequential(0.1));
  for (const trust of [0.25, 0.5, 0.75, 1]) assert.ok(chroma(trust) > chroma(trust - 0.25));
});
