import { useMemo } from "preact/hooks";
import * as api from "../../../api.ts";
import { drawnWheel } from "../../../lib/tire/surface/drawn-wheel.ts";
import { readSurface, type Surface } from "../../../lib/tire/surface/surface-reader.ts";
import type { Sight } from "../../../lib/tire/view-address.ts";
import { answerTo, type Loadable } from "../../../state/loadable.ts";
import { useAsked } from "../../../state/use-asked.ts";
import { MapFigure } from "../../study/tire/map/map-figure.tsx";
import { useEye } from "../../study/tire/wheel/use-eye.ts";
import { WheelButtons } from "../../study/tire/wheel/wheel-buttons.tsx";
import { radiusOf, WheelCanvas, wheelActions } from "../../study/tire/wheel/wheel-canvas.tsx";
import { ComparedName, type SeenPlace } from "./compared-maps.tsx";
import type { ComparedLayer } from "./compared-model.ts";

interface Props {
  layers: readonly ComparedLayer[];
  baseline: string | null;
  title: string;
  seen: SeenPlace;
  sight: Sight;
  onSight: (change: Partial<Sight>) => void;
}

/** The tires with one eye, one cut, one deformation and one scale of length: what turns one turns all. */
export function ComparedWheels({ layers, baseline, title, seen, sight, onSight }: Props) {
  const surfaces = useSurfaces(layers);
  const eye = useEye(sight.eye, (to) => onSight({ eye: to }));
  const actions = wheelActions(eye, sight.isCut, onSight);
  const ready = surfaces.flatMap((surface) => (surface.status === "ready" ? [surface.value] : []));
  // The largest is the one that the eye goes about, so that all of them fit.
  const radius_mm = useMemo(() => Math.max(1, ...ready.map(radiusOf)), [surfaces]);
  return (
    <>
      <div class="compared-figures compared-wheels">
        {layers.map((layer, k) => (
          <div key={layer.id} data-study={layer.id}>
            <ComparedName layer={layer} baseline={baseline} kind="values" />
            <OneWheel layer={layer} surface={surfaces[k] ?? { status: "loading" }} {...{ title, radius_mm, sight, eye, actions, seen }} />
          </div>
        ))}
      </div>
      <WheelButtons
        actions={actions}
        factor={sight.factor}
        onFactor={(factor) => onSight({ factor })}
        isCut={sight.isCut}
        hasGround={ready.some(({ ground }) => ground !== null)}
      />
    </>
  );
}

type WheelProps = Omit<Parameters<typeof WheelCanvas>[0], "model" | "surface" | "point" | "onPoint" | "onPin"> & {
  layer: ComparedLayer;
  surface: Loadable<Surface>;
  seen: SeenPlace;
};

/** One of them; its map where it can't be drawn. */
function OneWheel({ layer, surface, seen, title, ...rest }: WheelProps) {
  const { map } = layer;
  if (map === null) return <p class="quiet">{layer.why}</p>;
  const name = `${layer.number}: ${layer.name}, ${title}`;
  const unrolled = <MapFigure model={map} title={name} {...seen} />;
  if (surface.status === "loading") return <p class="quiet wheel wheel-missing">Loading the tire …</p>;
  const missing = (
    <>
      <p class="quiet" role="status">
        {surface.status === "failed" ? "The service sends no skins of this tire" : "This browser has no WebGL, or lost it"}: its map is shown.
      </p>
      {unrolled}
    </>
  );
  if (surface.status === "failed") return missing;
  return (
    <WheelCanvas {...rest} model={map} surface={surface.value} title={name} point={seen.point} onPoint={seen.onPoint} onPin={seen.onPin} missing={missing} />
  );
}

function useSurfaces(layers: readonly ComparedLayer[]): readonly Loadable<Surface>[] {
  const key = layers.map(({ id }) => id).join();
  const asked = useAsked(key, (ids) => Promise.all(ids.split(",").map((id) => answerTo(api.surface(id).then(readSurface)))));
  return useMemo(() => {
    if (asked?.status !== "ready") return layers.map(() => ({ status: "loading" }) as const);
    return asked.value.map((answer, k) => (answer.status === "ready" ? { status: "ready", value: drawnWheel(answer.value, sectorOf(layers[k])) } : answer));
  }, [asked?.status, key]);
}

/** The angles around the wheel that a map covers. */
function sectorOf(layer: ComparedLayer | undefined): [number, number] {
  const theta = layer?.map?.shown.field.theta_deg ?? [];
  return [theta[0] ?? -45, theta[theta.length - 1] ?? 45];
}
