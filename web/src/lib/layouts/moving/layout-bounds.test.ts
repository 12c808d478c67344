import assert from "node:assert/strict";
import { test } from "node:test";
import type { FilmFields } from "../../../wire.ts";
import { curveAt, turnOf } from "./film-turn.ts";
import { layoutBounds, readyFields } from "./layout-bounds.ts";

const WIDTH_DEG = 20;
const NOISE = 0.02;
const bell = Array.from({ length: 360 }, (_, k) => Math.exp(-0.5 * ((k - 180) / WIDTH_DEG) ** 2));

/** A Gaussian contact that grows with the depth, h = d exp(-u^2 / 2 s^2), at a depth of 1 mm. */
function fields(noise: Partial<FilmFields["noise"]> = {}): FilmFields {
  return {
    unit: "strain",
    size_mm: null,
    noise: { floor: NOISE, gain_std: 0, place_std_deg: 0, ...noise },
    kinds: [{ phi_deg: 0, angle_deg: 90 }],
    loads: [{ depth_mm: 1, load_n: 13, force_slope_n_per_mm: 13, signals: [bell], slopes_per_mm: [bell] }],
  };
}

const evenly = (units: number) => Array.from({ length: units }, (_, k) => ({ theta_deg: (360 / units) * k, phi_deg: 0, angle_deg: 90 }));

test("curves go through their samples and have the slopes of a smooth function", () => {
  const turn = turnOf(bell);
  assert.equal(curveAt(turn, 17).value, bell[197]);
  const at = -31.3;
  const value = Math.exp(-0.5 * (at / WIDTH_DEG) ** 2);
  // A cubic through values and slopes a degree apart: h^4 / 384 of the fourth derivative.
  assert.ok(Math.abs(curveAt(turn, at).value - value) < 1e-7);
  assert.ok(Math.abs(curveAt(turn, at + 360).slope - (-at / WIDTH_DEG ** 2) * value) < 1e-6);
});

test("dense films reach the closed form of the bound", () => {
  // Spacing D much below the width s: (noise / d) sqrt(2 s D / sqrt(pi)), as in the service's own test.
  const [found] = layoutBounds(readyFields(fields()), evenly(72)) ?? [];
  assert.ok(found !== undefined && "bounds" in found);
  const expected = NOISE * Math.sqrt((2 * WIDTH_DEG * 5) / Math.sqrt(Math.PI));
  for (const angle of [found.bounds.worst_angle_deg, found.bounds.rms_angle_deg]) assert.ok(Math.abs(angle / expected - 1) < 1e-5);
});

test("errors of gains and places make bounds worse", () => {
  const worst = (noise: Partial<FilmFields["noise"]>): number => {
    const [found] = layoutBounds(readyFields(fields(noise)), evenly(18)) ?? [];
    assert.ok(found !== undefined && "bounds" in found);
    return found.bounds.worst_angle_deg;
  };
  assert.ok(worst({ gain_std: 0.1 }) > 1.1 * worst({}));
  assert.ok(worst({ place_std_deg: 1 }) > 1.1 * worst({}));
});

test("contacts that differ make bounds worse as the noise would", () => {
  const worst = (given: FilmFields): number => {
    const [found] = layoutBounds(readyFields(given), evenly(18)) ?? [];
    assert.ok(found !== undefined && "bounds" in found);
    return found.bounds.worst_angle_deg;
  };
  const spread = fields();
  // Three times the noise's variance, everywhere: twice its deviation.
  for (const load of spread.loads) load.variances = [Array.from(bell, () => 3 * NOISE * NOISE)];
  assert.ok(Math.abs(worst(spread) / worst(fields()) - 2) < 1e-9);
});

test("films that see nothing say where, and unknown kinds give nothing", () => {
  const ready = readyFields(fields());
  const [blind] = layoutBounds(ready, evenly(1)) ?? [];
  assert.ok(blind !== undefined && "blind_deg" in blind && blind.blind_deg === 0);
  assert.equal(layoutBounds(ready, [{ theta_deg: 0, phi_deg: 3, angle_deg: 90 }]), null);
});
