import type { ComponentChildren } from "preact";

/** A drawing that keeps its size and is scrolled by itself where the window is narrower, so that its text stays readable. */
export function WideDrawing({ name, children }: { name: string; children: ComponentChildren }) {
  return (
    <div class="wide-drawing" tabIndex={0} role="group" aria-label={name}>
      {children}
    </div>
  );
}
