/** The uncertain inputs of the form: their distributions and which fields they can vary. */

import { isTable, pathOfPointer, valueAt, type Table } from "../document-values.ts";
import type { NumberField } from "./scene-fields.ts";

/** The parameters of each distribution, in the order in which people say them. */
export const PARAMETERS: Readonly<Record<string, readonly string[]>> = {
  uniform: ["min", "max"],
  normal: ["mean", "std"],
  lognormal: ["mu", "sigma"],
  exponential: ["rate"],
  gamma: ["shape", "scale"],
  weibull: ["shape", "scale"],
  beta: ["alpha", "beta", "min", "max"],
  gumbel: ["location", "scale"],
  triangular: ["min", "mode", "max"],
};

export interface InputRow {
  name: string;
  vary: string;
  distribution: Table;
}

/** The inputs of a document, as far as they are some. */
export function inputsOf(document: unknown): InputRow[] {
  const inputs = valueAt(document, "/inputs");
  return !Array.isArray(inputs)
    ? []
    : inputs.map((input) => {
        const { name, vary, distribution } = isTable(input) ? input : {};
        return { name: String(name ?? ""), vary: String(vary ?? ""), distribution: isTable(distribution) ? distribution : {} };
      });
}

/** Where a distribution lies and how far it reaches about there: of a uniform one half its width, of a normal one its standard deviation. */
export interface Spread {
  centre: number;
  half: number;
}

export function spreadOf(distribution: Table): Spread | null {
  const [first, second] = distribution.kind === "uniform" ? ["min", "max"] : distribution.kind === "normal" ? ["mean", "std"] : [];
  const [a, b] = [distribution[first ?? ""], distribution[second ?? ""]];
  if (typeof a !== "number" || typeof b !== "number") return null;
  return distribution.kind === "uniform" ? { centre: tidy((a + b) / 2), half: tidy((b - a) / 2) } : { centre: a, half: b };
}

/** A distribution of the same kind with another spread; all else that it says stays. */
export function withSpread(distribution: Table, { centre, half }: Spread): Table {
  const ends = distribution.kind === "uniform" ? { min: tidy(centre - half), max: tidy(centre + half) } : { mean: centre, std: half };
  return { ...distribution, ...ends };
}

/** The spread that all contact depths that vary share; null where they differ, or fewer than two vary. */
export function commonDepths(inputs: readonly InputRow[]): Spread | null {
  const spreads = inputs.filter(isDepth).map(({ distribution }) => spreadOf(distribution));
  const [first] = spreads;
  const alike = spreads.every((spread) => spread?.centre === first?.centre && spread?.half === first?.half);
  return spreads.length > 1 && alike ? (first ?? null) : null;
}

/** The inputs with another spread of all contact depths. */
export function withCommonDepths(inputs: readonly unknown[], spread: Spread): unknown[] {
  return inputs.map((input, index) => {
    const row = inputsOf({ inputs })[index];
    return row === undefined || !isDepth(row) ? input : { ...(input as Table), distribution: withSpread(row.distribution, spread) };
  });
}

function isDepth({ vary }: InputRow): boolean {
  return vary.startsWith("ground.depths_mm[");
}

/** A distribution of another kind that lies where the first did. */
export function withKind(distribution: Table, kind: string): Table {
  const { centre, half } = spreadOf(distribution) ?? { centre: 1, half: 0.3 };
  const rate = centre > 0 ? tidy(1 / centre) : 1;
  const made: Readonly<Record<string, Table>> = {
    uniform: { min: tidy(centre - half), max: tidy(centre + half) },
    normal: { mean: centre, std: half },
    lognormal: { mu: tidy(Math.log(Math.max(centre, 1e-6))), sigma: 0.3 },
    exponential: { rate },
    gamma: { shape: 9, scale: tidy(centre / 9) },
    weibull: { shape: 3, scale: centre },
    beta: { alpha: 2, beta: 2, min: tidy(centre - half), max: tidy(centre + half) },
    gumbel: { location: centre, scale: half },
    triangular: { min: tidy(centre - half), mode: centre, max: tidy(centre + half) },
  };
  return { kind, ...made[kind] };
}

/** A further input: the first field that doesn't vary yet, by 30 % about its value. */
export function furtherInput(document: unknown, fields: readonly NumberField[]): InputRow | null {
  const inputs = inputsOf(document);
  const taken = new Set(inputs.map(({ vary }) => vary));
  const free = fields.find(({ pointer }) => !taken.has(pathOfPointer(pointer)) && typeof valueAt(document, pointer) === "number");
  if (free === undefined) return null;
  const centre = valueAt(document, free.pointer) as number;
  const vary = pathOfPointer(free.pointer);
  const names = new Set(inputs.map(({ name }) => name));
  const plain = vary.split(".").at(-1) ?? vary;
  const name = names.has(plain) ? `${plain} ${inputs.length + 1}` : plain;
  return { name, vary, distribution: withSpread({ kind: "uniform" }, { centre, half: centre === 0 ? 0.1 : tidy(Math.abs(centre) * 0.3) }) };
}

/** What a field stands at when a study is begun: of one that varies the centre of its distribution. */
export function meanAt(document: unknown, pointer: string): { value: number; half: number } | null {
  const path = pathOfPointer(pointer);
  const input = inputsOf(document).find(({ vary }) => vary === path);
  const spread = input === undefined ? null : spreadOf(input.distribution);
  if (spread !== null) return { value: spread.centre, half: spread.half };
  const value = valueAt(document, pointer);
  return typeof value === "number" ? { value, half: 0 } : null;
}

/** Without the tail that binary fractions leave behind sums. */
function tidy(value: number): number {
  return Number(value.toPrecision(12));
}
