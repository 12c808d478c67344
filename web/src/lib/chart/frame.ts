import type { Ends } from "./scales.ts";

/** How large a chart is, and the lines between which its values are drawn, in its own units. */
export interface Frame {
  width: number;
  height: number;
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/** A frame with so much beside its values for axes. */
export function frameOf(width: number, height: number, beside: Pick<Frame, "left" | "right" | "top" | "bottom">): Frame {
  return { width, height, left: beside.left, right: width - beside.right, top: beside.top, bottom: height - beside.bottom };
}

/** Where a scale across the frame begins and ends. */
export const across = ({ left, right }: Frame): Ends => [left, right];

/** Where one begins and ends that grows upwards. */
export const upwards = ({ bottom, top }: Frame): Ends => [bottom, top];
