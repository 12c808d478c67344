import assert from "node:assert/strict";
import { test } from "node:test";
import {
  added,
  areTwice,
  begunWith,
  changed,
  dropped,
  filmsFrom,
  filmsText,
  freeLayoutToml,
  movedTo,
  nearestTo,
  turnedInto,
  undone,
  withFreeLayout,
} from "./moved-films.ts";

const film = (theta_deg: number, angle_deg = 90, phi_deg = 0) => ({ theta_deg, phi_deg, angle_deg });
const FILMS = [film(0), film(120), film(240, 0, -45)];

test("films are moved, dropped, added and turned, and each step can be undone", () => {
  assert.deepEqual(movedTo(FILMS, 0, -1)[0], film(359));
  assert.deepEqual(dropped(FILMS, 1), [FILMS[0], FILMS[2]]);
  assert.deepEqual(added(FILMS, { phi_deg: 0, angle_deg: 0 }, 361.5).at(-1), film(1.5, 0));
  assert.deepEqual(turnedInto(FILMS, 2, { phi_deg: 0, angle_deg: 90 })[2], film(240));
  const steps = changed(changed(begunWith(FILMS), dropped(FILMS, 0)), []);
  assert.deepEqual(undone(steps).films, dropped(FILMS, 0));
  assert.deepEqual(undone(undone(undone(steps))), begunWith(FILMS));
});

test("the nearest film is found over the end of the turn", () => {
  assert.equal(nearestTo(FILMS, -3), 0);
  assert.equal(nearestTo(FILMS, 200), 2);
  assert.equal(nearestTo([], 0), null);
});

test("two films of one kind at one place are seen", () => {
  assert.equal(areTwice(FILMS), false);
  assert.equal(areTwice([...FILMS, film(0, 0)]), false);
  assert.equal(areTwice([...FILMS, film(120)]), true);
});

test("an address has the films to the last digit, or nothing", () => {
  const films = [...FILMS, film(360 / 7)];
  assert.deepEqual(filmsFrom(filmsText(films)), films);
  for (const text of [null, "", "0*0", "0*0*90_", "0*0*x", "0*0*9999", "0**90"]) assert.equal(filmsFrom(text), null);
});

test("a document takes the layout beside those that it has", () => {
  const once = withFreeLayout({ name: "a", layouts: { units: [12] } }, FILMS);
  assert.deepEqual(once, { name: "a", layouts: { units: [12], free: [{ name: "by hand", films: FILMS }] } });
  const twice = withFreeLayout(once, [film(1)]) as { layouts: { free: { name: string }[] } };
  assert.deepEqual(
    twice.layouts.free.map(({ name }) => name),
    ["by hand", "by hand 2"],
  );
});

test("TOML to copy is a free layout", () => {
  const lines = freeLayoutToml("by hand", [film(12.5)]).split("\n");
  assert.deepEqual(lines, ["[[layouts.free]]", 'name = "by hand"', "films = [", "  { theta_deg = 12.5, phi_deg = 0, angle_deg = 90 },", "]"]);
});
