import type { ComponentChildren } from "preact";
import { QUANTITIES, type Quantity, type Route } from "../../../lib/route.ts";
import type { Direction, StudyResult } from "../../../types.ts";

type StudyRoute = Extract<Route, { view: "study" }>;

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
      <Choice legend="Direction">
        {(["x", "y"] as Direction[]).map((direction) => (
          <Radio
            key={direction}
            name="map-direction"
            value={direction}
            label={direction}
            checked={route.direction === direction}
            onChoose={() => set({ direction })}
          />
        ))}
      </Choice>
      <Choice legend="Show">
        {QUANTITIES.map((quantity) => (
          <Radio
            key={quantity}
            name="map-quantity"
            value={quantity}
            label={QUANTITY_NAMES[quantity]}
            checked={route.quantity === quantity}
            onChoose={() => set({ quantity })}
          />
        ))}
      </Choice>
      {route.quantity === "index" && (
        <Choice legend="Of the depth at">
          {result.inputs.map(({ name }) => (
            <Radio
              key={name}
              name="map-input"
              value={name}
              label={name}
              checked={name === inputName}
              onChoose={() => set({ input: name })}
            />
          ))}
        </Choice>
      )}
    </div>
  );
}

function Choice({ legend, children }: { legend: string; children: ComponentChildren }) {
  return (
    <fieldset class="choice">
      <legend>{legend}</legend>
      {children}
    </fieldset>
  );
}

function Radio(props: { name: string; value: string; label: string; checked: boolean; onChoose: () => void }) {
  const { name, value, label, checked, onChoose } = props;
  return (
    <label>
      <input type="radio" name={name} value={value} checked={checked} onChange={onChoose} />
      <span>{label}</span>
    </label>
  );
}
