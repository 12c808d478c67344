import { useState } from "preact/hooks";
import { useSight } from "../../../state/use-sight.ts";
import { directionName } from "../../../lib/direction.ts";
import { QUANTITIES, type CompareRoute, type DrawnAs } from "../../../lib/route.ts";
import type { SurfacePoint } from "../../../lib/tire/map/map-grid.ts";
import { asWritten } from "../../../lib/tire/view-address.ts";
import { later } from "../../shared/later.tsx";
import { RadioChoice, type Option } from "../../shared/radio-choice.tsx";
import { LayerChoices, QUANTITY_NAMES } from "../../study/tire/layer-choices.tsx";
import { TireLegend } from "../../study/tire/tire-legend.tsx";
import { LayoutRanks } from "../layout-ranks-table.tsx";
import { ComparedMaps } from "./compared-maps.tsx";
import { drawnOf, inputNames, inputOf, useLayers, useResults } from "./compared-model.ts";
import { ComparedReading } from "./compared-reading.tsx";
import { DifferenceLegend } from "./difference-legend.tsx";

const ComparedWheels = later("the tires", async () => (await import("./compared-wheels.tsx")).ComparedWheels);

const DRAWN: readonly Option<DrawnAs>[] = [
  { value: "maps", label: "Maps" },
  { value: "tires", label: "Tires" },
];
/** Films' signals are no field that could be compared place by place. */
const COMPARED = QUANTITIES.filter((quantity) => quantity !== "signal");

interface Props {
  route: CompareRoute;
  /** As the service took it. */
  baseline: string | null;
  onAdjust: (route: CompareRoute) => void;
}

/** The inner surfaces side by side on one scale, and how they differ from the baseline's. */
export function ComparedTires({ route, baseline, onAdjust }: Props) {
  const [sight, setSight] = useSight(route.sight, (seen) => onAdjust({ ...route, sight: seen }));
  const [hovered, setHovered] = useState<SurfacePoint | null>(null);
  const studies = drawnOf(route.studies, baseline);
  const answers = useResults(studies);
  const layers = useLayers(route, studies, answers, baseline, sight.scale);
  const results = answers.flatMap((answer) => (answer.status === "ready" ? [answer.value] : []));
  const set = (change: Partial<CompareRoute>): void => onAdjust({ ...route, sight, ...change });
  const title = titleOf(route, inputOf(route, results));
  const point = hovered ?? sight.pin;
  const seen = { point, pinned: sight.pin, onPoint: setHovered, onPin: (pin: SurfacePoint | null) => setSight({ pin }) };
  const shown = layers.flatMap(({ map }) => (map === null ? [] : [map]))[0] ?? null;
  const difference = layers.flatMap((layer) => (layer.difference === null ? [] : [layer.difference]))[0] ?? null;
  const keep = (isKept: boolean): void => setSight({ scale: isKept && shown !== null ? endsOf(shown.shown.field.scale) : null });
  if (answers.some(({ status }) => status === "loading")) {
    return (
      <p class="quiet compared-loading" role="status">
        Loading the maps …
      </p>
    );
  }
  return (
    <>
      <section class="panel compared" aria-labelledby="compared-title">
        <h2 id="compared-title">Their inner surfaces on one scale</h2>
        {studies.length < route.studies.length && <p class="quiet">Of {studies.length} of them: the first ones, and the baseline.</p>}
        <div class="controls">
          <RadioChoice name="compared-as" legend="Drawn as" options={DRAWN} chosen={route.drawnAs} onChoose={(drawnAs) => set({ drawnAs })} />
          <LayerChoices
            group="compared"
            direction={route.direction}
            quantity={route.quantity}
            input={inputOf(route, results)}
            quantities={COMPARED}
            inputs={inputNames(results)}
            onChoose={(change) => set(change.quantity === undefined ? change : { ...change, sight: { ...sight, scale: null } })}
          />
        </div>
        {route.drawnAs === "maps" ? (
          <ComparedMaps kind="values" layers={layers} baseline={baseline} title={title} seen={seen} />
        ) : (
          <ComparedWheels layers={layers} baseline={baseline} title={title} seen={seen} sight={sight} onSight={setSight} />
        )}
        {shown !== null && (
          <TireLegend
            field={shown.shown.field}
            title={`${title}; one scale for all`}
            beyond_deg={shown.shown.field.theta_deg.at(-1) ?? 0}
            isKept={sight.scale !== null}
            onKeep={keep}
          />
        )}
      </section>
      <section class="panel compared" aria-labelledby="differences-title">
        <h2 id="differences-title">Difference maps</h2>
        {difference === null ? (
          <p class="quiet">{whyNone(route)}</p>
        ) : (
          <>
            <ComparedMaps kind="difference" layers={layers} baseline={baseline} title={`Difference, ${title}`} seen={seen} />
            <DifferenceLegend field={difference.shown.field} quantity={route.quantity} title={`${title}: the study minus the baseline`} />
          </>
        )}
        <ComparedReading
          layers={layers}
          baseline={baseline}
          point={point}
          isPinned={sight.pin !== null && hovered === null}
          onRelease={() => setSight({ pin: null })}
        />
      </section>
      <LayoutRanks layers={layers} answers={answers} baseline={baseline} />
    </>
  );
}

function endsOf({ low, high }: { low: number; high: number }): [number, number] {
  return [asWritten(low), asWritten(high)];
}

function titleOf({ quantity, direction }: CompareRoute, input: string): string {
  const ofInput = quantity === "index" || quantity === "total" || quantity === "error";
  const unit = ofInput ? "percent" : "µε (10⁻⁶)";
  return `${QUANTITY_NAMES[quantity]}${ofInput ? ` of ${input}` : ""}, ${quantity === "strain" ? "" : "strain "}${directionName(direction)}, ${unit}`;
}

function whyNone({ quantity }: CompareRoute): string {
  if (quantity === "error") return "Errors are estimates without an error of their own, so that their difference says nothing: choose another layer.";
  return "There is nothing to take a difference of: the baseline and another study must both have this layer.";
}
