import { borders, type Cell, type Field } from "../../../lib/study/surface-field.ts";

/** Where the surface lies inside the figure, in CSS pixels; phi grows upwards. */
export interface Frame {
  width: number;
  height: number;
  left: number;
  top: number;
  plotWidth: number;
  plotHeight: number;
  thetas: number[];
  phis: number[];
}

const MARGIN = { left: 74, right: 12, top: 10, bottom: 40 };

/** The frame of a field in a figure of this width. */
export function frameOf(field: Field, width: number): Frame {
  const height = Math.round(Math.min(460, Math.max(280, width * 0.42)));
  return {
    width,
    height,
    left: MARGIN.left,
    top: MARGIN.top,
    plotWidth: Math.max(1, width - MARGIN.left - MARGIN.right),
    plotHeight: height - MARGIN.top - MARGIN.bottom,
    thetas: borders(field.theta_deg),
    phis: borders(field.phi_deg),
  };
}

const ends = (edges: number[]): [number, number] => [edges[0] as number, edges[edges.length - 1] as number];

/** Pixels from the left of the figure. */
export function xOf(frame: Frame, theta_deg: number): number {
  const [first, last] = ends(frame.thetas);
  return frame.left + (frame.plotWidth * (theta_deg - first)) / (last - first);
}

/** Pixels from the top of the figure. */
export function yOf(frame: Frame, phi_deg: number): number {
  const [first, last] = ends(frame.phis);
  return frame.top + frame.plotHeight * (1 - (phi_deg - first) / (last - first));
}

/** The angles under a pixel. */
export function anglesAt(frame: Frame, x: number, y: number): { theta_deg: number; phi_deg: number } {
  const [thetaFirst, thetaLast] = ends(frame.thetas);
  const [phiFirst, phiLast] = ends(frame.phis);
  return {
    theta_deg: thetaFirst + ((x - frame.left) / frame.plotWidth) * (thetaLast - thetaFirst),
    phi_deg: phiFirst + (1 - (y - frame.top) / frame.plotHeight) * (phiLast - phiFirst),
  };
}

/** The rectangle of a cell. */
export function cellBox(frame: Frame, cell: Cell): { x: number; y: number; width: number; height: number } {
  const [left, right] = [xOf(frame, frame.thetas[cell.column] ?? 0), xOf(frame, frame.thetas[cell.column + 1] ?? 0)];
  const [bottom, top] = [yOf(frame, frame.phis[cell.row] ?? 0), yOf(frame, frame.phis[cell.row + 1] ?? 0)];
  const [x, y] = [Math.min(left, right), Math.min(bottom, top)];
  return { x, y, width: Math.abs(right - left), height: Math.abs(bottom - top) };
}
