import { microstrain, MISSING, percent } from "../../../lib/format.ts";
import { cornersAt, interpolate, type SurfacePoint } from "../../../lib/tire/map/map-grid.ts";
import type { Field } from "../../../lib/tire/map/surface-field.ts";
import { Readout } from "../../study/tire/reading/readout.tsx";
import type { ComparedLayer } from "./compared-model.ts";

interface Props {
  layers: readonly ComparedLayer[];
  baseline: string | null;
  point: SurfacePoint | null;
  isPinned: boolean;
  onRelease: () => void;
}

/** Every study at one place. Without a place the table stands empty, so that nothing moves when the pointer comes. */
export function ComparedReading({ layers, baseline, point, isPinned, onRelease }: Props) {
  return (
    <section class="reading" aria-labelledby="compared-reading-title">
      <h3 id="compared-reading-title">At one place</h3>
      <Readout
        point={point}
        isPinned={isPinned}
        onRelease={onRelease}
        hint="Point at a map to read all of them there; click, or press Enter, to pin the place."
      />
      <table class="point-table" aria-label="All studies at the place">
        <thead>
          <tr>
            <td></td>
            <th scope="col">value</th>
            <th scope="col">minus the baseline</th>
          </tr>
        </thead>
        <tbody>
          {layers.map((layer) => (
            <tr key={layer.id} data-study={layer.id}>
              <th scope="row">
                {layer.number}: {layer.name}
              </th>
              <td>{words(layer.map?.shown.field, point)}</td>
              <td>{layer.id === baseline ? "baseline" : words(layer.difference?.shown.field, point)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

/** A value with its error, where the layer has one. */
function words(field: Field | undefined, point: SurfacePoint | null): string {
  const corners = field === undefined || point === null ? null : cornersAt(field, point);
  if (field === undefined || corners === null) return MISSING;
  const [value, error] = [interpolate(field.values, corners), interpolate(field.errors, corners)];
  if (value === null) return MISSING;
  const [show, unit] = field.scale.unit === "percent" ? [(of: number) => percent(of), "%"] : [microstrain, "µε"];
  // Strains and deviations stand without an error: a map has none of them.
  const hasError = field.quantity === "index" || field.quantity === "total" || field.quantity === "difference";
  const isTotal = field.quantity === "total";
  return `${show(value)}${hasError ? ` ± ${error === null || isTotal ? "?" : show(error)}` : ""} ${unit}`;
}
