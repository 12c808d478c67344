import { useState } from "preact/hooks";
import { useSight } from "../../../state/use-sight.ts";
import { directionName, type Direction } from "../../../lib/direction.ts";
import { fixed, significant } from "../../../lib/format.ts";
import { layoutWords } from "../../../lib/layouts/layout-words.ts";
import type { StudyRoute } from "../../../lib/route.ts";
import { isSamePlace, type SurfacePoint } from "../../../lib/tire/map/map-grid.ts";
import { readingAt } from "../../../lib/tire/map/point-reading.ts";
import { countStatus, type Field } from "../../../lib/tire/map/surface-field.ts";
import { strainAt, unitOf, valueAt } from "../../../lib/tire/surface/section-lines.ts";
import { asWritten, type Sight } from "../../../lib/tire/view-address.ts";
import type { FilmModel, FilmPlace } from "../../../wire.ts";
import { Figure } from "../../shared/picture/figure.tsx";
import type { SectionProps } from "../section-props.ts";
import { MapFigure } from "./map/map-figure.tsx";
import { FilmVolts } from "./reading/film-volts.tsx";
import { DepthPlot } from "./reading/depth-plot.tsx";
import { InputSlider } from "./reading/input-slider.tsx";
import { PointTable } from "./reading/point-table.tsx";
import { TireControls } from "./tire-controls.tsx";
import { TireLegend } from "./tire-legend.tsx";
import { useTireModel, type TireModel } from "./tire-model.ts";
import { WheelFigure } from "./wheel/wheel-figure.tsx";

/** The tire with what was computed on it; another study's begins anew. */
export function TireView(props: SectionProps) {
  return <Tire key={props.route.id} {...props} />;
}

/** The tire beside its unrolled inner surface, with one reading of both. */
function Tire({ result, study, route, onAdjust }: SectionProps) {
  const [sight, setSight] = useSight(route.sight, (seen) => onAdjust({ ...route, sight: seen }));
  const [hovered, setHovered] = useState<SurfacePoint | null>(null);
  const model = useTireModel(result, study, route, sight);
  const title = titleOf(route, model);
  const { pin: pinned } = sight;
  const keep = (isKept: boolean): void => setSight({ scale: isKept && model.shown !== null ? endsOfScale(model.shown.field) : null });
  const pin = (point: SurfacePoint | null): void => setSight({ pin: point });
  const point = hovered ?? pinned;
  const edge_deg = result.map?.theta_deg.at(-1) ?? 0;
  const figures = { model, title, point, pinned, onPoint: setHovered, onPin: pin };
  return (
    <section class="panel" aria-labelledby="tire-title">
      <h2 id="tire-title">The tire and its inner surface</h2>
      <TireControls
        result={result}
        route={route}
        model={model}
        onAdjust={(next) => onAdjust({ ...next, sight: sightOf(sight, next.quantity !== route.quantity) })}
        onLayout={(layout) => setSight({ layout })}
      />
      <div class="tire-figures">
        <div>
          {model.shown === null ? (
            <NoMap hasMap={result.map != null} />
          ) : (
            <Figure study={result.study.name} name={`map of ${route.quantity} ${route.direction}`}>
              <MapFigure {...figures} />
            </Figure>
          )}
          {route.quantity !== "signal" && <FilmsBeyond films={model.films} edge_deg={edge_deg} />}
          {model.shown !== null && (
            <TireLegend
              field={model.shown.field}
              title={title}
              films={filmsIn(route, model)}
              beyond_deg={edge_deg}
              isKept={sight.scale !== null}
              onKeep={keep}
            />
          )}
          {route.quantity === "signal" && model.signals !== null && <FilmVolts films={model.signals.films} direction={route.direction} />}
        </div>
        <WheelFigure {...figures} sight={sight} onSight={setSight} study={result.study.name} />
      </div>
      {result.map != null && (
        <div class="tire-readings">
          <PointTable
            reading={point === null ? null : readingAt(result.map, model.rulers, point, strainsOf(model))}
            where={whereOf(model)}
            isPinned={pinned !== null && isSamePlace(point, pinned)}
            unit={model.rulers.unit}
            inputs={result.inputs.map(({ name }) => name)}
            onRelease={() => pin(null)}
          />
          <div>
            <InputSlider
              model={model}
              quantityIsStrain={route.quantity === "strain"}
              value={sight.value}
              onWant={model.askForLine}
              onValue={(value) => setSight({ value })}
            />
            {pinned !== null && model.line?.status === "ready" && (
              <DepthPlot line={model.line.value} point={pinned} direction={route.direction} value={sight.value} />
            )}
          </div>
        </div>
      )}
      {model.shown !== null && <Remarks field={model.shown.field} unit={model.rulers.unit} />}
    </section>
  );
}

/** As finely as the address has them, so that a link shows the same colours. */
function endsOfScale({ scale: { low, high } }: Field): [number, number] {
  return [asWritten(low), asWritten(high)];
}

/** What stays seen when another layer is chosen: the slider goes to the means, and a scale belongs to its quantity. */
function sightOf(sight: Sight, isOther: boolean): Sight {
  return { ...sight, value: null, scale: isOther ? null : sight.scale };
}

/** The strains where the slider stands; undefined at the means. */
function strainsOf({ between }: TireModel): Parameters<typeof readingAt>[3] {
  return between === null ? undefined : { x: strainAt(between, "x"), y: strainAt(between, "y") };
}

function whereOf({ between, line, inputName }: TireModel): string {
  if (between === null || line?.status !== "ready") return "at the means";
  return `at ${inputName} = ${significant(valueAt(between))} ${unitOf(line.value.vary)}`.trimEnd();
}

function titleOf({ quantity, direction }: StudyRoute, model: TireModel): string {
  const { inputName } = model;
  const strain = `strain ${directionName(direction)}`;
  switch (quantity) {
    case "index":
      return `First-order index of ${inputName}, ${strain}, percent of its variance`;
    case "total":
      return `Total index of ${inputName}, ${strain}, percent of its variance`;
    case "std":
      return `Standard deviation of the ${strain}, µε (10⁻⁶)`;
    case "strain":
      return `Strain ${directionName(direction)}, ${whereOf(model)}, µε (10⁻⁶)`;
    case "error":
      return `Error of the first-order index of ${inputName}, ${strain}, percentage points`;
    case "signal":
      return signalTitle(model, direction);
  }
}

/** Films whose signals are drawn have colours of the scale instead. */
function filmsIn({ quantity }: StudyRoute, { layout }: TireModel): string | null {
  return layout === null || quantity === "signal" ? null : layoutWords(layout);
}

const FILM_MODELS: Record<FilmModel, string> = {
  coupled: "glued films, with their stiffness,",
  transfer: "glued films, by transfer from the bare wall,",
  bare: "bare films, which follow the wall,",
};

function signalTitle({ signals }: TireModel, direction: Direction): string {
  if (signals === null) return "This study solved no films' signals along this direction";
  return `Open circuit volts of ${FILM_MODELS[signals.model]} along ${direction}, at ${significant(signals.load_n)} N, V`;
}

/** Where the films are that the map doesn't reach. */
function FilmsBeyond({ films, edge_deg }: { films: readonly FilmPlace[]; edge_deg: number }) {
  const beyond = films.map(({ theta_deg }) => Math.abs(theta_deg)).filter((theta) => theta > edge_deg);
  if (films.length === 0 || edge_deg === 0) return null;
  const reach = `The map reaches ${fixed(edge_deg, 0)}° to both sides`;
  return (
    <p class="quiet">
      {beyond.length === 0
        ? "All films of the layout are on the map."
        : `${reach}: ${beyond.length} of ${films.length} films lie beyond its arrows, the nearest at ${fixed(Math.min(...beyond), 1)}°.`}
    </p>
  );
}

function NoMap({ hasMap }: { hasMap: boolean }) {
  if (hasMap) return <p class="quiet">This result's map doesn't hold this quantity: choose another.</p>;
  return (
    <p class="quiet">
      This study asked for no map, so nothing is known between the places. Add <code>"grid": {'{"circumferential": 61, "meridional": 21}'}</code> to its
      candidates.
    </p>
  );
}

function Remarks({ field, unit }: { field: Field; unit: string }) {
  const counts = field.quantity === "strain" || field.quantity === "signal" ? {} : countStatus(field.status);
  const [broken, constant, unusable] = [counts["product-form-broken"] ?? 0, counts.constant ?? 0, counts.unusable ?? 0];
  const parts = [
    unit === "mm"
      ? "The map is to scale along the crown and across the section; off the crown the wheel is narrower than drawn."
      : "This result doesn't hold the map's shape, so the map is drawn over angles, not to scale.",
    broken > 0 && `At ${broken} of ${field.status.length} grid points M-DRM's product form is broken; their indices come from another method.`,
    constant > 0 && `${constant} grid points don't vary with the inputs and have no index.`,
    unusable > 0 && `${unusable} grid points have no index because too few solves have a strain there.`,
  ];
  return <p class="quiet">{parts.filter(Boolean).join(" ")}</p>;
}
