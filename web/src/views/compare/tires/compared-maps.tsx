import type { SurfacePoint } from "../../../lib/tire/map/map-grid.ts";
import { Figure } from "../../shared/picture/figure.tsx";
import { MapFigure } from "../../study/tire/map/map-figure.tsx";
import type { ComparedLayer } from "./compared-model.ts";

/** The place that all figures show, and what they say of it. */
export interface SeenPlace {
  point: SurfacePoint | null;
  pinned: SurfacePoint | null;
  onPoint: (point: SurfacePoint | null) => void;
  onPin: (point: SurfacePoint | null) => void;
}

interface Props {
  kind: "values" | "difference";
  layers: readonly ComparedLayer[];
  baseline: string | null;
  title: string;
  seen: SeenPlace;
}

/** One unrolled map for each study, or for each but the baseline. */
export function ComparedMaps({ kind, layers, baseline, title, seen }: Props) {
  const shown = kind === "values" ? layers : layers.filter(({ id }) => id !== baseline);
  return (
    <div class={`compared-figures compared-${kind}`}>
      {shown.map((layer) => {
        const map = kind === "values" ? layer.map : layer.difference;
        const name = `${layer.number}: ${layer.name}`;
        return (
          <div key={layer.id} data-study={layer.id}>
            <ComparedName layer={layer} baseline={baseline} kind={kind} />
            {map === null ? (
              <p class="quiet">{layer.why ?? "The baseline doesn't have this layer."}</p>
            ) : (
              <Figure study={layer.name} name={`${kind} ${layer.number}`}>
                <MapFigure model={map} title={`${name}, ${title}`} {...seen} />
              </Figure>
            )}
          </div>
        );
      })}
    </div>
  );
}

/** `2: its name`, and what it is drawn against. */
export function ComparedName({ layer, baseline, kind }: { layer: ComparedLayer; baseline: string | null; kind: Props["kind"] }) {
  return (
    <h3 class="compared-name">
      {layer.number}: {layer.name === "" ? "no result" : layer.name}
      {layer.id === baseline && <span class="quiet"> baseline</span>}
      {kind === "difference" && <span class="quiet"> minus the baseline</span>}
    </h3>
  );
}
