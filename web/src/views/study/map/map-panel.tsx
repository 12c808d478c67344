import { useState } from "preact/hooks";
import { directionName } from "../../../lib/direction.ts";
import { fixed, microstrain, percent } from "../../../lib/format.ts";
import type { Quantity, Route, StudyRoute } from "../../../lib/route.ts";
import { statusName } from "../../../lib/study/output-words.ts";
import { centreName } from "../../../lib/study/result-picks.ts";
import { countStatus, fieldOf, indexOf, locationMarks, type Cell, type Field } from "../../../lib/study/surface-field.ts";
import type { StudyResult } from "../../../wire.ts";
import { MapControls } from "./map-controls.tsx";
import { MapFigure } from "./map-figure.tsx";
import { Legend } from "./map-legend.tsx";

/** The unrolled inner surface of the tire. */
export function MapPanel(props: { result: StudyResult; route: StudyRoute; onAdjust: (route: Route) => void }) {
  const { result, route, onAdjust } = props;
  const [cell, setCell] = useState<Cell | null>(null);
  const input = inputIndex(result, route.input);
  const inputName = result.inputs[input]?.name ?? "";
  const field = result.map == null ? null : fieldOf(result.map, route.direction, route.quantity, input);
  const title = titleOf(route, inputName);
  return (
    <section class="panel" aria-labelledby="map-title">
      <h2 id="map-title">Map of the inner surface</h2>
      {field === null ? (
        <p class="quiet">
          This study asked for no map. Add <code>"grid": {'{"circumferential": 61, "meridional": 21}'}</code> to its
          candidates.
        </p>
      ) : (
        <>
          <MapControls result={result} route={route} inputName={inputName} onAdjust={onAdjust} />
          <MapFigure
            field={field}
            marks={locationMarks(result.cut_point.locations)}
            title={title}
            cell={cell}
            onCell={setCell}
          />
          <Readout field={field} cell={cell} quantity={route.quantity} title={title} />
          <Legend scale={field.scale} title={title} />
          <Remarks field={field} quantity={route.quantity} />
        </>
      )}
    </section>
  );
}

/** The input of the route, or the centre's own. */
function inputIndex(result: StudyResult, name: string | null): number {
  const find = (wanted: string | null): number => result.inputs.findIndex((input) => input.name === wanted);
  const chosen = find(name);
  if (chosen >= 0) return chosen;
  return Math.max(0, find(centreName(result)));
}

function titleOf({ quantity, direction }: StudyRoute, input: string): string {
  const strain = `strain ${directionName(direction)}`;
  switch (quantity) {
    case "index":
      return `First-order index of ${input}, ${strain}, percent of its variance`;
    case "std":
      return `Standard deviation of the ${strain}, µε (10⁻⁶)`;
    case "strain":
      return `Strain at the cut point (all inputs at their means), ${directionName(direction)}, µε (10⁻⁶)`;
    case "error":
      return `Error of the first-order indices, ${strain}, percentage points`;
  }
}

function Readout(props: { field: Field; cell: Cell | null; quantity: Quantity; title: string }) {
  const { field, cell, quantity, title } = props;
  if (cell === null) {
    return (
      <p class="readout quiet">Point at the map, or give it the focus and use the arrow keys, to read a value.</p>
    );
  }
  const index = indexOf(field, cell);
  const value = field.values[index] ?? null;
  const error = field.errors[index] ?? null;
  const shown = field.scale.unit === "percent" ? percent(value, 2) : microstrain(value);
  const unit = quantity === "index" ? " %" : quantity === "error" ? " points" : " µε";
  const bar = error === null ? "error unknown" : `± ${percent(error, 2)} points`;
  return (
    <p class="readout" role="status" title={title}>
      <span>θ {fixed(field.theta_deg[cell.column], 1)}°</span>
      <span>φ {fixed(field.phi_deg[cell.row], 1)}°</span>
      <strong>{value === null ? "no value" : `${shown}${unit}`}</strong>
      {quantity === "index" ? <span>{bar}</span> : quantity !== "error" && <span>indices here {bar}</span>}
      <span>status: {statusName(field.status[index] ?? "ok")}</span>
    </p>
  );
}

function Remarks({ field, quantity }: { field: Field; quantity: Quantity }) {
  const counts = countStatus(field.judged ? field.status : []);
  const [broken, constant, unusable] = [counts["product-form-broken"] ?? 0, counts["constant"] ?? 0, counts["unusable"] ?? 0];
  const parts = [
    quantity === "index" &&
      "An index is a share: where the strain hardly varies it says nothing, so look at the standard deviation too.",
    broken > 0 &&
      `${broken} of ${field.status.length} cells are hatched because M-DRM's product form is broken there; their indices come from another method.`,
    constant > 0 && `${constant} hatched cells don't vary with the inputs and have no index.`,
    unusable > 0 && `${unusable} hatched cells have no index because too few points have a strain there.`,
    "Unrolled, not to scale: θ around the wheel from the contact centre, φ across the section from the crown.",
  ];
  return <p class="quiet">{parts.filter(Boolean).join(" ")}</p>;
}
