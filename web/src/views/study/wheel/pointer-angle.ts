import type { TargetedPointerEvent } from "preact";

/** Of the pointer about the wheel's middle: 0 below, positive to the right, degrees. */
export function pointerAngle(event: TargetedPointerEvent<HTMLDivElement>): number {
  const { left, top, width } = event.currentTarget.getBoundingClientRect();
  const middle = width / 2;
  return (Math.atan2(event.clientX - left - middle, event.clientY - top - middle) * 180) / Math.PI;
}
