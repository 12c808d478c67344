import assert from "node:assert/strict";
import { test } from "node:test";
import type { LayoutAnswer, PlaceAnswer, StudyResult } from "../../../wire.ts";
import { besideWords, inputWords, layoutStanding, leadOf, leftOutWords, placeWords, surerWords, typeset, unrankedWords } from "./answer-words.ts";

test("terminal signs become those of print", () => {
  assert.equal(typeset("the angle to 9.2 +- 1.5 degrees, every 30 degrees, 2 mm deep"), "the angle to 9.2 ± 1.5°, every 30°, 2\u00a0mm deep");
});

test("a reason's lead ends before its figures", () => {
  assert.equal(leadOf("Rank 2 can't be told from it: by the error, it has 8 +- 1."), "Rank 2 can't be told from it.");
  assert.equal(leadOf("It is the only layout that was asked for."), "It is the only layout that was asked for.");
  assert.equal(leadOf("Of the layouts tried with up to 30 films no other is as good: it has 0.9 degrees."), "No other is as good.");
  assert.equal(leadOf("It has 4 degrees; of fewer films 12 come closest with 97: how far off these are isn't known."), "How far off these are isn't known.");
  assert.equal(leadOf("It has 4 degrees; of fewer films 12 come closest with 97 degrees."), "Of fewer films 12 come closest with 97°.");
  assert.equal(leadOf("Two sentences. The second: longer."), "Two sentences.");
});

test("places and layouts in a few words", () => {
  const place: PlaceAnswer = { names: ["P2", "P4"], direction: "y", index: 0.3, error: null, verdict: "unknown", reason: "", sentence: "" };
  assert.equal(placeWords(place), "P2, P4 in y, 30.0 %");
  assert.equal(placeWords({ ...place, error: 0.02 }), "P2, P4 in y, 30.0 ± 2.0 %");
  assert.equal(placeWords({ ...place, index: 1, error: 1e-9 }), "P2, P4 in y, 100.0 %");
  const layout = { film_count: 12, tied_with: [] as number[] } as LayoutAnswer;
  assert.equal(layoutStanding(layout), "12 films");
  assert.equal(layoutStanding({ ...layout, tied_with: [2, 5] }), "12 films, level with rank 2, 5");
  assert.equal(layoutStanding({ ...layout, film_count: 1, tied_with: [2, 3, 4, 5] }), "1 film, level with rank 2, 3, 4 and 1 more");
});

test("what is left out is told with its effect", () => {
  assert.equal(leftOutWords({ what: "friction", why: "", effect: 0.0631, sentence: "" }), "friction, 6.3 % of the strain");
});

test("a study that ranks nothing says what it tells", () => {
  const study = { inputs: [{ name: "wall" }], signals: null, layouts: [] } as unknown as StudyResult;
  assert.match(unrankedWords(study), /how much wall changes the strain/);
  assert.match(unrankedWords({ ...study, signals: {} } as StudyResult), /what films read/);
});

test("what a surer answer costs, as far as it is known", () => {
  const surer = { sentence: "", level: "reference", times: 1.7013, expected_s: 32 };
  assert.equal(surerWords(surer), "reference mesh, about 32 s");
  assert.equal(surerWords({ ...surer, expected_s: null }), "reference mesh, 1.7 times the work");
  assert.equal(surerWords({ ...surer, times: null, expected_s: null }), "reference mesh");
});

test("the inputs that matter most are told with their errors", () => {
  const share = (input: string, index: number, error: number | null) => ({ input, index, error });
  const shares = [share("cords", 0.39, 0.012), share("P3", 0.301, null), share("P2", 0.1, 0.008), share("wall", 0.05, 0.008)];
  const words = inputWords({ sentence: "", location: "P3", direction: "y", shares });
  assert.equal(words, "cords 39.0 ± 1.2 %, P3 30.1 %, P2 10.0 ± 0.8 % of y at P3");
});

test("what inputs do to an angle is told beside noise, and to volts by the inputs", () => {
  const share = (input: string, index: number) => ({ input, index, error: null });
  const beside = { quantity: "", sentence: "", std: 2 };
  assert.equal(besideWords({ ...beside, unit: "degrees", shares: [share("P2", 0.75), share("noise", 0.25)] }), "2.00° rms; noise alone 1.00°");
  assert.equal(besideWords({ ...beside, unit: "V", shares: [share("pressure", 0.81), share("P3", 0.12)] }), "pressure 81 %, P3 12 % of 2.00 V");
});
