import assert from "node:assert/strict";
import { test } from "node:test";
import { sheetPieces } from "./sheet-pieces.ts";

test("strips are cut apart midway between them, the head with the first", () => {
  const strips = [
    { y_mm: 22, height_mm: 40 },
    { y_mm: 74, height_mm: 40 },
  ];
  assert.deepEqual(sheetPieces(126, strips), [
    { strip: 0, y_mm: 0, height_mm: 68 },
    { strip: 1, y_mm: 68, height_mm: 58 },
  ]);
  assert.deepEqual(sheetPieces(126, []), []);
});

test("a strip higher than paper is cut into equal parts that it holds, without a gap", () => {
  const strips = [
    { y_mm: 22, height_mm: 400 },
    { y_mm: 434, height_mm: 400 },
  ];
  const pieces = sheetPieces(846, strips);
  assert.deepEqual(
    pieces.map(({ strip }) => strip),
    [0, 0, 1, 1],
  );
  let end_mm = 0;
  for (const { y_mm, height_mm } of pieces) {
    assert.ok(Math.abs(y_mm - end_mm) < 1e-9 && height_mm <= 245, `${y_mm} ${height_mm}`);
    end_mm = y_mm + height_mm;
  }
  assert.equal(end_mm, 846);
});
