import assert from "node:assert/strict";
import { test } from "node:test";
import { changedName, changesSince, comparedFields, differences, differenceWords, named } from "./document-differences.ts";

const FIRST = {
  name: "X",
  scene: { geometry: { wall_mm: 4 }, ground: { depths_mm: [1, 1] } },
  inputs: [{ name: "P1", distribution: { kind: "uniform", min: 0.7, max: 1.3 } }],
};

test("a difference is told by its field, the new value and the old one", () => {
  const found = differences(FIRST, { ...FIRST, name: "Y", scene: { ...FIRST.scene, geometry: { wall_mm: 5 } } });
  assert.equal(differenceWords(found), "wall_mm 5 instead of 4");
  assert.equal(found[0]?.pointer, "/scene/geometry/wall_mm");
  assert.equal(differenceWords(differences(FIRST, { ...FIRST, name: "another name" })), null);
});

test("inputs go by their names, entries of lists by their place, what is new or gone by none", () => {
  const changed = {
    ...FIRST,
    scene: { geometry: {}, ground: { depths_mm: [1, 2] } },
    inputs: [{ name: "P1", distribution: { kind: "uniform", min: 0.7, max: 2 } }],
    method: { nodes: 3 },
  };
  const labels = differences(FIRST, changed).map(({ label }) => label);
  assert.deepEqual(labels, ["wall_mm", "depths_mm[1]", "P1 max", "method"]);
  assert.equal(differenceWords(differences(FIRST, changed)), "wall_mm none instead of 4, depths_mm[1] 2 instead of 1, P1 max 2 instead of 1.3 and 1 more");
});

test("a list of another length is one difference", () => {
  const found = differences({ units: [4, 5] }, { units: [4] });
  assert.deepEqual(
    found.map(({ pointer }) => pointer),
    ["/units"],
  );
});

test("a name says what differs, and says it once however often a study is run again", () => {
  const wall = (value: number) => [{ pointer: "/scene/geometry/wall_mm", label: "wall_mm", before: 4, after: value }];
  assert.equal(changedName("X", []), "X");
  assert.equal(changedName("X", wall(5)), "X · wall_mm = 5");
  assert.equal(changedName("X · wall_mm = 5", wall(6)), "X · wall_mm = 6");
  const friction = [{ pointer: "/f", label: "friction", before: 0, after: 0.5 }];
  assert.equal(changedName("X · wall_mm = 5", friction), "X · wall_mm = 5, friction = 0.5");
  assert.ok(changedName("n".repeat(200), wall(5)).length <= 200);
});

test("a draft that only spells its scene otherwise differs in nothing, and its writer's name stays", () => {
  const scenes = [{ name: "tire", document: { geometry: { wall_mm: 4 } } }];
  const origin = { name: "X", document: { name: "X", scene: { preset: "tire" }, accuracy: { preset: "standard" } } };
  assert.deepEqual(changesSince(origin, { ...origin.document, scene: { geometry: { wall_mm: 4 } } }, scenes), []);
  const thicker = { ...origin.document, scene: { preset: "tire", geometry: { wall_mm: 5 } } };
  assert.deepEqual(named(thicker, origin, scenes), { ...thicker, name: "X · wall_mm = 5" });
  assert.deepEqual(named({ ...thicker, name: "mine" }, origin, scenes), { ...thicker, name: "mine" });
  const finer = { ...origin.document, accuracy: { preset: "reference" } };
  assert.deepEqual(named(finer, origin, scenes), { ...finer, name: "X · accuracy = reference" });
});

test("documents are compared field by field, and what one has otherwise as a whole is one field", () => {
  const documents = [
    { name: "a", wall_mm: 3, layouts: { units: [4] } },
    { name: "b", wall_mm: 4, layouts: { units: [5] } },
    { name: "c", wall_mm: 3 },
  ];
  assert.deepEqual(comparedFields(documents), [
    { pointer: "/wall_mm", label: "wall_mm", values: ["3", "4", "3"] },
    { pointer: "/layouts", label: "layouts", values: ["a table", "a table", "none"] },
  ]);
  assert.deepEqual(comparedFields([{ a: 1 }, { a: 1 }]), []);
});
