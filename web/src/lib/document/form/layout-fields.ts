/** What the form shows of a document's layouts. */

import { numberIn } from "./scene-fields.ts";

export type DirectionSets = "both" | "x" | "y" | "all";

const SETS: Readonly<Record<DirectionSets, readonly (readonly string[])[]>> = {
  both: [["x", "y"]],
  x: [["x"]],
  y: [["y"]],
  all: [["x", "y"], ["y"], ["x"]],
};

/** Which of the usual sets of directions a document asks for; `own` where it is another. Left out, units have both. */
export function directionSets(value: unknown): DirectionSets | "own" {
  if (value === undefined) return "both";
  const names = Object.keys(SETS) as DirectionSets[];
  return names.find((name) => JSON.stringify(SETS[name]) === JSON.stringify(value)) ?? "own";
}

/** The sets by their name. */
export function setsNamed(name: DirectionSets): readonly (readonly string[])[] {
  return SETS[name];
}

/** Length and width of the films, mm; null for points. */
export function layoutSize(value: unknown): [number, number] | null {
  const [length, width] = Array.isArray(value) ? (value as unknown[]) : [];
  return typeof length === "number" && typeof width === "number" ? [length, width] : null;
}

/** Numbers with commas between them; null where one is none. */
export function listIn(text: string): number[] | null {
  const parts = text.split(/[,;\s]+/).filter((part) => part !== "");
  const numbers = parts.map(numberIn);
  return numbers.every((number) => number !== null) ? numbers : null;
}
