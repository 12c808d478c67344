import assert from "node:assert/strict";
import { test } from "node:test";
import type { SignalRow, StudyResult } from "../../../wire.ts";
import { GREY } from "../map/trust.ts";
import { signalFilms, signalPatches, voltScale } from "./signal-films.ts";

function row(change: Partial<SignalRow>): SignalRow {
  return {
    tire: "own",
    film: "coupled",
    position: "crown",
    direction: "x",
    over: "contact",
    load_n: 20,
    pressure_mpa: 0.2,
    contact_deg: 0,
    open_circuit_v: 10,
    error: { open_circuit_v: 1 },
    ...change,
  } as SignalRow;
}

const resultOf = (rows: SignalRow[]): StudyResult => ({ signals: { rows, curves: [], pairs: [], widths: [], claims: [] } }) as unknown as StudyResult;
const document = { signals: { film: { length_mm: 5, width_mm: 3 } } };

test("films of one tire, model, direction and axis are shown, with their size", () => {
  const rows = [
    row({}),
    row({ position: "shoulder", contact_deg: 10, open_circuit_v: -4 }),
    row({ film: "bare", open_circuit_v: 500 }),
    row({ tire: "soft" }),
    row({ direction: "y" }),
    row({ over: "load" }),
    row({ contact_deg: 20, open_circuit_v: null, error: null }),
  ];
  const shown = signalFilms(resultOf(rows), { document }, "x");
  assert.deepEqual(shown, {
    model: "coupled",
    load_n: 20,
    size: [5, 3],
    films: [
      { position: "crown", contact_deg: 0, volts: 10, error: 1 },
      { position: "shoulder", contact_deg: 10, volts: -4, error: 1 },
    ],
  });
  assert.equal(signalFilms(resultOf([row({ film: "bare" })]), { document: {} }, "x")?.model, "bare", "a bare film where no glued one was solved");
});

test("without a solved film there is nothing to show", () => {
  assert.equal(signalFilms({} as StudyResult, { document: {} }, "x"), null);
  assert.equal(signalFilms(resultOf([row({ open_circuit_v: null })]), { document }, "x"), null);
});

test("zero is the middle of the scale, and a signal within its error is grey", () => {
  const films = [
    { position: "crown", contact_deg: 0, volts: 8, error: null },
    { position: "shoulder", contact_deg: 10, volts: -2, error: 3 },
  ];
  const scale = voltScale(films);
  assert.deepEqual([scale.low, scale.high], [-8, 8]);
  const [crown, shoulder] = signalPatches({ model: "coupled", load_n: 20, films, size: null }, "y", scale);
  assert.deepEqual(crown, { theta_deg: 0, phi_deg: 0, angle_deg: 90, colour: scale.colour(1) });
  assert.deepEqual([shoulder?.phi_deg, shoulder?.colour], [45, GREY]);
  assert.equal(voltScale([]).high, 1);
});
