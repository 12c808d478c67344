/** One Tab stop for a group of links and buttons, arrow keys within it, as ARIA's practices have it for composite widgets. */

/** Where the focus is: a row, and a place in it. */
interface Spot {
  row: number;
  at: number;
}

/** Where a key leads, with the lengths of the rows; null for other keys and over an edge. A lone row goes round. */
export function movedTo({ row, at }: Spot, rows: readonly number[], key: string): Spot | null {
  const length = rows[row] ?? 0;
  const isLone = rows.length === 1;
  switch (key) {
    case "ArrowLeft":
      return inRow({ row, at: isLone ? (at + length - 1) % length : at - 1 }, rows);
    case "ArrowRight":
      return inRow({ row, at: isLone ? (at + 1) % length : at + 1 }, rows);
    case "ArrowUp":
      return nearest(row - 1, at, rows);
    case "ArrowDown":
      return nearest(row + 1, at, rows);
    case "Home":
      return isLone ? inRow({ row, at: 0 }, rows) : nearest(0, at, rows);
    case "End":
      return isLone ? inRow({ row, at: length - 1 }, rows) : nearest(rows.length - 1, at, rows);
    default:
      return null;
  }
}

function inRow(spot: Spot, rows: readonly number[]): Spot | null {
  return spot.at >= 0 && spot.at < (rows[spot.row] ?? 0) ? spot : null;
}

/** The same place of another row, or its last. */
function nearest(row: number, at: number, rows: readonly number[]): Spot | null {
  const length = rows[row] ?? 0;
  return length === 0 ? null : { row, at: Math.min(at, length - 1) };
}
