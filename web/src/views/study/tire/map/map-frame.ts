import { across, frameOf, upwards, type Frame } from "../../../../lib/chart/frame.ts";
import { linear, type Linear } from "../../../../lib/chart/scales.ts";
import { angleAt, endsOf, markAt, type Rulers } from "../../../../lib/tire/map/arc-length.ts";
import type { SurfacePoint } from "../../../../lib/tire/map/map-grid.ts";

/** Where the surface lies inside the figure, in CSS pixels; phi grows upwards. */
export interface MapFrame extends Frame {
  rulers: Rulers;
  /** Where a ruler's mark lies. */
  x: Linear;
  y: Linear;
}

const MARGIN = { left: 46, right: 96, top: 36, bottom: 42 };
/** On narrow pages the places of the section have their name alone. */
const NARROW = { below: 420, right: 62 };
/** Of figures in degrees, which have no scale to keep. */
const PLAIN_RATIO = 0.5;
const HIGHEST = 420;

/** The frame of a map in a figure of this width: to scale where lengths are known. */
export function mapFrame(rulers: Rulers, width: number): MapFrame {
  const ends = [endsOf(rulers.along), endsOf(rulers.across)] as const;
  const [along, over] = ends.map(([low, high]) => Math.max(high - low, Number.EPSILON)) as [number, number];
  const ratio = rulers.unit === "mm" ? over / along : PLAIN_RATIO;
  const room = Math.max(1, width - MARGIN.left - (isNarrow(width) ? NARROW.right : MARGIN.right));
  const high = Math.min(HIGHEST, room * ratio);
  const frame = frameOf(width, Math.round(high + MARGIN.top + MARGIN.bottom), MARGIN);
  const plot = { ...frame, right: frame.left + high / ratio, bottom: frame.top + high };
  return { ...plot, rulers, x: linear(ends[0], across(plot)), y: linear(ends[1], upwards(plot)) };
}

export function isNarrow(width: number): boolean {
  return width < NARROW.below;
}

/** Pixels from the left of the figure. */
export function xOf({ x, rulers }: MapFrame, theta_deg: number): number {
  return x(markAt(rulers.along, theta_deg));
}

/** Pixels from the top of the figure. */
export function yOf({ y, rulers }: MapFrame, phi_deg: number): number {
  return y(markAt(rulers.across, phi_deg));
}

/** The angles under a pixel; null beside the map. */
export function anglesAt({ left, right, top, bottom, x, y, rulers }: MapFrame, atX: number, atY: number): SurfacePoint | null {
  if (atX < left || atX > right || atY < top || atY > bottom) return null;
  return { theta_deg: angleAt(rulers.along, x.invert(atX)), phi_deg: angleAt(rulers.across, y.invert(atY)) };
}
