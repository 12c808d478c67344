/** A column over time as a small picture: a band from the least to the greatest of each bin, gaps, samples that stand alone. */

import { closedPath, type Point } from "../chart/paths.ts";
import { across, type Frame, upwards } from "../chart/frame.ts";
import { linear, padded } from "../chart/scales.ts";
import type { ColumnLook, ColumnSeries, RecordingLook } from "../../wire.ts";

/** Marks of an SVG. */
export interface LookDrawing {
  band: string;
  gaps: { x: number; width: number }[];
  lone: { x: number; y: number }[];
}

/** A gap that is narrower isn't seen. */
const LEAST_WIDTH = 1.5;

export function lookDrawing(recording: RecordingLook, column: ColumnLook, series: ColumnSeries, frame: Frame): LookDrawing {
  const bins = series.least.length;
  const x = linear([0, recording.duration_s], across(frame));
  const y = linear(padded([column.least ?? 0, column.greatest ?? 0]), upwards(frame));
  const middle = (bin: number): number => ((bin + 0.5) * recording.duration_s) / bins;
  const gaps = recording.gaps.first.map(({ begin_s, length_s }) => ({ from: begin_s - recording.begin_s, length: length_s }));
  const parts: { time: number; low: number; high: number }[][] = [[]];
  let last = -Infinity;
  for (let bin = 0; bin < bins; bin += 1) {
    const [low, high] = [series.least[bin], series.greatest[bin]];
    if (low == null || high == null) continue;
    const time = middle(bin);
    // Nothing is drawn over a gap.
    if (gaps.some(({ from, length }) => last < from + length / 2 && time > from + length / 2)) parts.push([]);
    parts.at(-1)?.push({ time, low, high });
    last = time;
  }
  const band = parts.map((part) =>
    closedPath([...part.map(({ time, high }): Point => [x(time), y(high)]), ...part.map(({ time, low }): Point => [x(time), y(low)]).reverse()]),
  );
  return {
    band: band.join(""),
    gaps: gaps.map(({ from, length }) => ({ x: x(from), width: Math.max(LEAST_WIDTH, x(from + length) - x(from)) })),
    lone: column.lone.first.map(({ time_s, value }) => ({ x: x(time_s - recording.begin_s), y: y(value) })),
  };
}
