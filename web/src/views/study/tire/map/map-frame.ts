import { angleAt, endsOf, markAt, type Rulers } from "../../../../lib/tire/map/arc-length.ts";
import type { SurfacePoint } from "../../../../lib/tire/map/map-grid.ts";

/** Where the surface lies inside the figure, in CSS pixels; phi grows upwards. */
export interface Frame {
  width: number;
  height: number;
  left: number;
  top: number;
  plotWidth: number;
  plotHeight: number;
  rulers: Rulers;
}

const MARGIN = { left: 46, right: 96, top: 36, bottom: 42 };
/** On narrow pages the places of the section have their name alone. */
const NARROW = { below: 420, right: 62 };
/** Of figures in degrees, which have no scale to keep. */
const PLAIN_RATIO = 0.5;
const HIGHEST = 420;

/** The frame of a map in a figure of this width: to scale where lengths are known. */
export function frameOf(rulers: Rulers, width: number): Frame {
  const [along, across] = [span(rulers.along), span(rulers.across)];
  const ratio = rulers.unit === "mm" ? across / along : PLAIN_RATIO;
  const room = Math.max(1, width - MARGIN.left - (isNarrow(width) ? NARROW.right : MARGIN.right));
  const plotHeight = Math.min(HIGHEST, room * ratio);
  const plotWidth = plotHeight / ratio;
  return { width, height: Math.round(plotHeight + MARGIN.top + MARGIN.bottom), left: MARGIN.left, top: MARGIN.top, plotWidth, plotHeight, rulers };
}

export function isNarrow(width: number): boolean {
  return width < NARROW.below;
}

function span(ruler: Rulers["along"]): number {
  const [low, high] = endsOf(ruler);
  return Math.max(high - low, Number.EPSILON);
}

/** Pixels from the left of the figure. */
export function xOf(frame: Frame, theta_deg: number): number {
  return xOfMark(frame, markAt(frame.rulers.along, theta_deg));
}

/** Pixels from the top of the figure. */
export function yOf(frame: Frame, phi_deg: number): number {
  return yOfMark(frame, markAt(frame.rulers.across, phi_deg));
}

export function xOfMark(frame: Frame, mark: number): number {
  return frame.left + (frame.plotWidth * (mark - endsOf(frame.rulers.along)[0])) / span(frame.rulers.along);
}

export function yOfMark(frame: Frame, mark: number): number {
  return frame.top + frame.plotHeight * (1 - (mark - endsOf(frame.rulers.across)[0]) / span(frame.rulers.across));
}

/** The angles under a pixel; null beside the map. */
export function anglesAt(frame: Frame, x: number, y: number): SurfacePoint | null {
  const [right, up] = [(x - frame.left) / frame.plotWidth, 1 - (y - frame.top) / frame.plotHeight];
  if (right < 0 || right > 1 || up < 0 || up > 1) return null;
  const { along, across } = frame.rulers;
  return {
    theta_deg: angleAt(along, endsOf(along)[0] + right * span(along)),
    phi_deg: angleAt(across, endsOf(across)[0] + up * span(across)),
  };
}
