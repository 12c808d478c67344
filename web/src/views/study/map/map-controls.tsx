import { DIRECTIONS } from "../../../lib/direction.ts";
import { QUANTITIES, type Quantity, type Route, type StudyRoute } from "../../../lib/route.ts";
import type { StudyResult } from "../../../wire.ts";
import { RadioChoice } from "../../shared/radio-choice.tsx";

const QUANTITY_NAMES: Record<Quantity, string> = {
  index: "First-order index",
  std: "Standard deviation",
  strain: "Strain at the means",
  error: "Error of the indices",
};

interface Props {
  result: StudyResult;
  route: StudyRoute;
  inputName: string;
  onAdjust: (route: Route) => void;
}

/** Chooses what the map shows; the choice goes into the address. */
export function MapControls({ result, route, inputName, onAdjust }: Props) {
  const set = (change: Partial<StudyRoute>): void => onAdjust({ ...route, ...change });
  return (
    <div class="controls">
      <RadioChoice
        name="map-direction"
        legend="Direction"
        options={DIRECTIONS.map((direction) => ({ value: direction, label: direction }))}
        chosen={route.direction}
        onChoose={(direction) => set({ direction })}
      />
      <RadioChoice
        name="map-quantity"
        legend="Show"
        options={QUANTITIES.map((quantity) => ({ value: quantity, label: QUANTITY_NAMES[quantity] }))}
        chosen={route.quantity}
        onChoose={(quantity) => set({ quantity })}
      />
      {route.quantity === "index" && (
        <RadioChoice
          name="map-input"
          legend="Of the depth at"
          options={result.inputs.map(({ name }) => ({ value: name, label: name }))}
          chosen={inputName}
          onChoose={(input) => set({ input })}
        />
      )}
    </div>
  );
}
