import type { ComponentChildren } from "preact";
import { fixed } from "../../../../lib/format.ts";
import type { SurfacePoint } from "../../../../lib/tire/map/map-grid.ts";

interface Props {
  point: SurfacePoint | null;
  isPinned: boolean;
  onRelease: () => void;
  /** What one does to read a place. */
  hint: string;
  /** What else is known of the place. */
  children?: ComponentChildren;
}

/** The place that is read, and a way to let a pinned one go. */
export function Readout({ point, isPinned, onRelease, hint, children }: Props) {
  return (
    <p class="readout" role="status">
      {point === null ? (
        <span class="quiet">{hint}</span>
      ) : (
        <strong data-theta={point.theta_deg} data-phi={point.phi_deg}>
          θ {fixed(point.theta_deg, 1)}°, φ {fixed(point.phi_deg, 1)}°
        </strong>
      )}
      {point !== null && children}
      {isPinned && (
        <button type="button" class="small-button" onClick={onRelease}>
          Let the pin go
        </button>
      )}
    </p>
  );
}
