import { layoutWords } from "../../../lib/layouts/layout-words.ts";
import { rankWords } from "../../../lib/format.ts";
import { QUANTITIES, type Quantity, type StudyRoute } from "../../../lib/route.ts";
import { answersLayout } from "../../../lib/study/result-picks.ts";
import type { RankedLayout, StudyResult } from "../../../wire.ts";
import { LayerChoices } from "./layer-choices.tsx";
import type { TireModel } from "./tire-model.ts";

/** Layouts that can be put on the tire. */
const LAYOUTS = 10;

interface Props {
  result: StudyResult;
  route: StudyRoute;
  model: TireModel;
  onAdjust: (route: StudyRoute) => void;
  onLayout: (layout: number | null) => void;
}

/** Chooses what tire and map show; what is of the map goes into the address. */
export function TireControls({ result, route, model, onAdjust, onLayout }: Props) {
  const set = (change: Partial<StudyRoute>): void => onAdjust({ ...route, ...change });
  const hasTotal = result.map?.layers.some((layer) => "total" in layer) === true;
  const isThere: Partial<Record<Quantity, boolean>> = { total: hasTotal, signal: model.signals !== null };
  const quantities = QUANTITIES.filter((quantity) => isThere[quantity] !== false);
  return (
    <div class="controls">
      {result.map != null && (
        <LayerChoices
          group="map"
          direction={route.direction}
          quantity={route.quantity}
          input={model.inputName}
          quantities={quantities}
          inputs={result.inputs.map(({ name }) => name)}
          onChoose={set}
        />
      )}
      <LayoutChoice result={result} chosen={model.layout} onChoose={onLayout} />
    </div>
  );
}

function LayoutChoice({ result, chosen, onChoose }: { result: StudyResult; chosen: RankedLayout | null; onChoose: (layout: number | null) => void }) {
  if (result.layouts.length === 0) return null;
  const answers = answersLayout(result);
  return (
    <label class="layout-choice">
      <span>Films of a layout</span>
      <select
        value={chosen === null ? "" : result.layouts.indexOf(chosen)}
        onChange={(event) => onChoose(event.currentTarget.value === "" ? null : Number(event.currentTarget.value))}
      >
        <option value="">none</option>
        {result.layouts.map(
          (layout, index) =>
            (index < LAYOUTS || layout === chosen || layout === answers) && (
              <option key={index} value={index}>
                {layout === answers ? "the answer" : rankWords(layout.rank, result.layouts)}: {layoutWords(layout)}
              </option>
            ),
        )}
      </select>
    </label>
  );
}
