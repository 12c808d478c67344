import assert from "node:assert/strict";
import { test } from "node:test";
import type { IndexMap, StudyResult } from "../../../wire.ts";
import type { Direction } from "../../direction.ts";
import type { Quantity } from "../../route.ts";
import { countStatus, fieldOf, filmNoise, locationMarks, shadeAt, shareOf } from "./surface-field.ts";
import { GREY } from "./trust.ts";

const map: IndexMap = {
  theta_deg: [-10, 0, 10],
  phi_deg: [-60, 60],
  layers: [
    {
      direction: "x",
      strain: [-0.02, 0, 0.01, 0, 0, 0],
      std: [0.001, 0.002, null, 0.004, 0, 0],
      first_order: [
        [0.1, 0.2, null, 0.4, 0.5, 0.6],
        [0.9, 0.8, null, 0.6, 0.5, 0.4],
      ],
      error: [0.01, 0.01, null, 0.02, 0.01, 0.01],
      first_order_error: [[0.001], [0.002]],
      total: [],
      status: ["ok", "ok", "constant", "product-form-broken", "ok", "ok"],
    },
  ],
  shape: { inflated_mm: [], displacement_mm: [] },
};
const field = (of: IndexMap, direction: Direction, quantity: Quantity, input: number, noise: number | null = null) =>
  fieldOf(of, { direction, quantity, input }, noise);

test("an index keeps the scale from 0 to 1, a deviation its own", () => {
  const index = field(map, "x", "index", 1);
  assert.deepEqual(index?.values.slice(0, 3), [0.9, 0.8, null]);
  assert.deepEqual([index?.scale.low, index?.scale.high, index?.scale.unit], [0, 1, "percent"]);
  const deviation = field(map, "x", "std", 0);
  assert.deepEqual([deviation?.scale.high, deviation?.scale.unit], [0.004, "microstrain"]);
});

test("an index has its own error", () => {
  assert.deepEqual(field(map, "x", "index", 1)?.errors, [0.002]);
  assert.deepEqual(field(map, "x", "error", 0)?.values, [0.001]);
});

test("signed strain has zero in the middle of its scale", () => {
  const strain = field(map, "x", "strain", 0);
  assert.ok(strain);
  assert.deepEqual([strain.scale.low, strain.scale.high], [-0.02, 0.02]);
  assert.equal(shareOf(strain.scale, 0), 0.5);
  assert.equal(shareOf(strain.scale, 9), 1);
});

test("a direction, an input or a total that the map doesn't have gives no field", () => {
  assert.equal(field(map, "y", "index", 0), null);
  assert.equal(field(map, "x", "index", 2), null);
  assert.equal(field(map, "x", "total", 0), null);
});

test("a place shows its value in colour, in grey below the noise or without a value", () => {
  const shade = (noise: number | null, index: number) => {
    const std = field(map, "x", "std", 0, noise);
    assert.ok(std);
    return shadeAt(std, [{ index, weight: 1 }]);
  };
  assert.deepEqual(shade(null, 3), { value: 0.004, trust: 1, colour: field(map, "x", "std", 0)?.scale.colour(1) });
  assert.deepEqual(shade(0.004, 3), { value: 0.004, trust: 0, colour: GREY });
  assert.deepEqual(shade(null, 2), { value: null, trust: 0, colour: GREY });
});

test("the noise is that of the layouts' films where these are read in strain", () => {
  const result = (unit: string) => ({ layouts: [{ score: { noise_strain: 0.0017 } }], layout_findings: { unit } }) as unknown as StudyResult;
  assert.equal(filmNoise(result("strain")), 0.0017);
  assert.equal(filmNoise(result("V")), null);
  assert.equal(filmNoise({ layouts: [] } as unknown as StudyResult), null);
});

test("locations lie on the crown and statuses are counted", () => {
  const marks = locationMarks([{ name: "P1", theta_deg: -4, strain_x: 0, strain_y: 0, von_mises_mpa: 0 }]);
  assert.deepEqual(marks, [{ name: "P1", theta_deg: -4, phi_deg: 0 }]);
  assert.deepEqual(countStatus(map.layers[0]?.status ?? []), { ok: 4, constant: 1, "product-form-broken": 1 });
});
