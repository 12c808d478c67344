/** Where the lines, the numbers and the title of an axis stand. */

import type { Frame } from "./frame.ts";

export type Side = "left" | "right" | "bottom" | "top";
/** In the chart's units, or a share of its width such as `50%`. */
export type Length = number | string;
/** A frame that may be as wide as its place. */
export type Edges = Omit<Frame, "right"> & { right: Length };

/** Through the whole chart, or short ones outside of it. */
export type Lines = "through" | "short";
/** Along the axis, or at an end: below an upright one, or above it. */
export type TitlePlace = "middle" | "start" | "end";

/** A text in an SVG. */
interface TextPlace {
  x?: Length;
  y?: number;
  transform?: string;
  "text-anchor": "start" | "middle" | "end";
}

/** Length of a short line, and what is left free beside lines. */
const [SHORT, FREE] = [4, 6];
/** Numbers stand so far below their middle, and below their top. */
const [HALF, WHOLE] = [4, 9];
/** What is left free at the chart's own edge, and there with a text. */
const [EDGE, FIRST] = [6, 12];

const isUpright = (side: Side): boolean => side === "left" || side === "right";

export function lineAt(side: Side, frame: Edges, place: Length, lines: Lines) {
  const through = isUpright(side) ? [frame.left, frame.right] : [frame.top, frame.bottom];
  const [from, to] = lines === "through" ? through : [frame[side], beyond(side, frame, SHORT)];
  return isUpright(side) ? { x1: from, x2: to, y1: place, y2: place } : { x1: place, x2: place, y1: from, y2: to };
}

export function numberAt(side: Side, frame: Edges, place: Length, lines: Lines | "none"): TextPlace {
  const free = lines === "short" ? SHORT + FREE : FREE;
  if (isUpright(side)) return { x: beyond(side, frame, free), y: Number(place) + HALF, "text-anchor": side === "left" ? "end" : "start" };
  return { x: place, y: side === "top" ? frame.top - free : frame.bottom + free + WHOLE, "text-anchor": "middle" };
}

export function titleAt(side: Side, frame: Edges, place: TitlePlace): TextPlace {
  if (isUpright(side)) return place === "middle" ? titleAlong(side, frame) : titleBeside(side, frame, place);
  const { left, right } = frame;
  const middle = typeof right === "string" ? "50%" : (left + right) / 2;
  return { x: { start: left, middle, end: right }[place], y: side === "top" ? FIRST : frame.height - EDGE, "text-anchor": place };
}

function titleAlong(side: Side, { width, top, bottom }: Edges): TextPlace {
  return { transform: `translate(${side === "left" ? FIRST : width - EDGE} ${(top + bottom) / 2}) rotate(-90)`, "text-anchor": "middle" };
}

function titleBeside(side: Side, { width, height, top }: Edges, place: "start" | "end"): TextPlace {
  const y = place === "start" ? height - EDGE : top - SHORT - FREE;
  return side === "left" ? { x: EDGE, y, "text-anchor": "start" } : { x: width - EDGE, y, "text-anchor": "end" };
}

/** So far outside of the chart. */
function beyond(side: Side, frame: Edges, by: number): Length {
  const edge = frame[side];
  if (typeof edge === "string") return edge;
  return side === "left" || side === "top" ? edge - by : edge + by;
}
