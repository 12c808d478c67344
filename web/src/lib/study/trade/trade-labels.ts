/** Names beside the points of a plot, placed where they cover neither each other nor a point. */

/** A point with its name, in the plot's units. */
interface Named {
  x: number;
  y: number;
  text: string;
}

interface PlacedLabel extends Named {
  anchor: "start" | "end";
}

interface Box {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/** Height of a line of text, and the mean width of a letter, for 11 px. */
const LINE = 13;
const LETTER = 6.2;
/** Between a point and its name. */
const APART = 8;
/** Steps up and down from a point, in lines, nearest first. */
const STEPS = [0, -1, 1, -2, 2, -3, 3];

/** Places the names in their order within a width; one that fits nowhere is left out, its point keeps its title. */
export function placeLabels(points: readonly Named[], width: number, height: number): PlacedLabel[] {
  const taken: Box[] = points.map(({ x, y }) => ({ left: x - 5, right: x + 5, top: y - 5, bottom: y + 5 }));
  const placed: PlacedLabel[] = [];
  for (const point of points) {
    const found = candidates(point).find(({ box }) => isFree(box, taken) && box.left >= 0 && box.right <= width && box.top >= 0 && box.bottom <= height);
    if (found === undefined) continue;
    taken.push(found.box);
    placed.push(found.label);
  }
  return placed;
}

function candidates(point: Named): { label: PlacedLabel; box: Box }[] {
  const long = LETTER * point.text.length;
  return STEPS.flatMap((step) =>
    (["start", "end"] as const).map((anchor) => {
      const x = anchor === "start" ? point.x + APART : point.x - APART;
      const y = point.y + 4 + step * LINE;
      const left = anchor === "start" ? x : x - long;
      return { label: { ...point, x, y, anchor }, box: { left, right: left + long, top: y - LINE + 2, bottom: y + 2 } };
    }),
  );
}

function isFree(box: Box, taken: readonly Box[]): boolean {
  return taken.every((other) => box.right <= other.left || other.right <= box.left || box.bottom <= other.top || other.bottom <= box.top);
}
