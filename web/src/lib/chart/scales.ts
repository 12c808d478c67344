/** Scales of charts and what is written along them, by d3-scale, which nothing else imports. */

import { scaleBand, scaleLinear, scaleLog, type ScaleBand, type ScaleLinear, type ScaleLogarithmic } from "d3-scale";
import { grouped, significant } from "../format.ts";

export type Ends = readonly [from: number, to: number];
export type Linear = ScaleLinear<number, number>;
type Log = ScaleLogarithmic<number, number>;

/** What stands along an axis: values, their places, and their texts. */
export interface Ticks<T, Place = number> {
  values: readonly T[];
  at: (value: T) => Place;
  text: (value: T) => string;
}

/** A straight scale. A lone value stands at its beginning. */
export function linear([low, high]: Ends, range: Ends): Linear {
  return scaleLinear([low, high > low ? high : low + 1], range);
}

/** From nothing to all; what errors reach beyond that is cut. */
export function percents(range: Ends): Linear {
  return linear([0, 100], range).clamp(true);
}

/** Round values, about so many, without decimals that say nothing. */
export function linearTicks(scale: Linear, count: number): Ticks<number> {
  const text = scale.tickFormat(count, "f");
  return { values: scale.ticks(count), at: scale, text: (value) => grouped(text(value)) };
}

/** A logarithmic scale. A lone value stands in its middle. */
export function log(domain: Ends, range: Ends): Log {
  return scaleLog(domain, range);
}

/** A logarithmic scale over whole powers of ten, at least one decade; the values must be positive. */
export function decades(values: readonly number[], range: Ends): Log {
  const scale = log(values.length === 0 ? [0.1, 1] : [Math.min(...values), Math.max(...values)], range).nice();
  const [low = 0.1, high = 1] = scale.domain();
  return scale.domain([low, Math.max(high, 10 * low)]);
}

/** Values of one digit that is among these: 1, 2 and 5, or the powers of ten alone. */
export function logTicks(scale: Log, digits: readonly number[]): Ticks<number> {
  const lead = (value: number): number => Number(value.toExponential(9).split("e")[0]);
  return { values: scale.ticks().filter((value) => digits.includes(lead(value))), at: scale, text: (value) => significant(value, 1) };
}

/** Places of equal breadth, one for each name; `gap` is the share that is free between two. */
export function places<T extends string | number>(names: readonly T[], range: Ends, gap = 0): ScaleBand<T> {
  return scaleBand(names, range)
    .paddingInner(gap)
    .paddingOuter(gap / 2);
}

/** Each name in the middle of its place. */
export function placeTicks<T extends string | number>(scale: ScaleBand<T>): Ticks<T> {
  return { values: scale.domain(), at: (name) => (scale(name) ?? 0) + scale.bandwidth() / 2, text: String };
}

/** Ends of a scale that holds all values and a little more. */
export function padded(values: readonly number[]): Ends {
  if (values.length === 0) return [0, 1];
  const low = values.reduce((least, value) => Math.min(least, value));
  const high = values.reduce((most, value) => Math.max(most, value));
  const margin = 0.05 * (high - low) || 1;
  return [low - margin, high + margin];
}
