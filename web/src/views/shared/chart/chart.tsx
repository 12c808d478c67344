import type { ComponentChildren } from "preact";
import type { Frame } from "../../../lib/chart/frame.ts";

interface Props {
  class?: string;
  frame: Frame;
  /** What those hear who don't see it. */
  label: string;
  /** Whether its units are pixels; else it is as wide as its place. */
  isFixed?: boolean;
  children: ComponentChildren;
}

/** A chart: one picture for screen readers, its axes and marks for all others. */
export function Chart({ class: kind, frame: { width, height }, label, isFixed = false, children }: Props) {
  const size = isFixed ? { width, height } : {};
  return (
    <svg class={kind} {...size} viewBox={`0 0 ${width} ${height}`} role="img" aria-label={label}>
      {children}
    </svg>
  );
}
