// Lines that a PDF strokes, where they lie on paper: enough of the format for what Chromium prints.
import { inflateSync } from "node:zlib";

const MM_PER_POINT = 25.4 / 72;

/** Lines of each page in order: both ends, mm from its lower left, and the length. */
export function linesOf(pdf) {
  const text = pdf.toString("latin1");
  const pages = [...text.matchAll(/<<\/Type \/Page\n.*?\/Contents (\d+) 0 R/gs)];
  return pages.map(([, number]) => linesIn(streamOf(pdf, text, number)));
}

/** The content of the object of a number, inflated. */
function streamOf(pdf, text, number) {
  const start = text.indexOf("stream\n", text.indexOf(`\n${number} 0 obj`)) + "stream\n".length;
  return inflateSync(pdf.subarray(start, text.indexOf("\nendstream", start))).toString("latin1");
}

/** Follows the matrix through `q`, `Q` and `cm`, and the pen through `m` and `l`. */
function linesIn(content) {
  const lines = [];
  const kept = [];
  let matrix = [1, 0, 0, 1, 0, 0];
  let pen = null;
  const onPaper = ([x, y]) => [matrix[0] * x + matrix[2] * y + matrix[4], matrix[1] * x + matrix[3] * y + matrix[5]].map((points) => points * MM_PER_POINT);
  for (const [, numbers, operator] of content.matchAll(/((?:-?[\d.]+\s+)*)(q|Q|cm|m|l)\b/g)) {
    const values = numbers.trim().split(/\s+/).map(Number);
    if (operator === "q") kept.push(matrix);
    else if (operator === "Q") matrix = kept.pop();
    else if (operator === "cm") matrix = product(values, matrix);
    else {
      const point = onPaper(values);
      if (operator === "l" && pen !== null) lines.push({ from: pen, to: point, length: Math.hypot(point[0] - pen[0], point[1] - pen[1]) });
      pen = point;
    }
  }
  return lines;
}

/** A matrix before another one, as the format multiplies them. */
function product([a, b, c, d, e, f], [A, B, C, D, E, F]) {
  return [a * A + b * C, a * B + b * D, c * A + d * C, c * B + d * D, e * A + f * C + E, e * B + f * D + F];
}
