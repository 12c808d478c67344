import { useMemo, useState } from "preact/hooks";
import * as api from "../../../api.ts";
import { answersLayout, centreName } from "../../../lib/study/result-picks.ts";
import { rulersOf, type Rulers } from "../../../lib/tire/map/arc-length.ts";
import { contourLines, type ContourLine } from "../../../lib/tire/map/contour-lines.ts";
import { rasterOf, type Raster } from "../../../lib/tire/map/field-raster.ts";
import { fieldOf, filmNoise, keptOn, locationMarks, type Field, type PlaceMark } from "../../../lib/tire/map/surface-field.ts";
import { filmsOf, type PatchSize, type ShownFilm } from "../../../lib/tire/surface/film-patches.ts";
import { movedSurface, nodesAbout, strainAt, type Between } from "../../../lib/tire/surface/section-lines.ts";
import { drawnWheel } from "../../../lib/tire/surface/drawn-wheel.ts";
import { readSurface, sectorOf, type Surface } from "../../../lib/tire/surface/surface-reader.ts";
import type { StudyRoute } from "../../../lib/route.ts";
import { signalFilms, signalPatches, voltScale, type SignalFilms } from "../../../lib/tire/surface/signal-films.ts";
import type { Sight } from "../../../lib/tire/view-address.ts";
import type { Loadable } from "../../../state/loadable.ts";
import { useAsked } from "../../../state/use-asked.ts";
import type { RankedLayout, Sections, StudyDetail, StudyResult } from "../../../wire.ts";

/** What a map and a tire draw. */
export interface MapModel {
  /** Null without a map, or without a layer of the choice. */
  shown: { field: Field; raster: Raster; contours: ContourLine[] } | null;
  rulers: Rulers;
  places: PlaceMark[];
  films: ShownFilm[];
  /** Null where films are points. */
  filmSize: PatchSize | null;
}

/** What tire and map show, chosen once for both. */
export interface TireModel extends MapModel {
  noise: number | null;
  /** The layout whose films are shown; null for none. */
  layout: RankedLayout | null;
  inputIndex: number;
  inputName: string;
  surface: Loadable<Surface>;
  /** Whether the surface is only the map's sector: the service sent no skins. */
  isSector: boolean;
  /** Solved values of the input; null until asked for. */
  line: Loadable<Sections> | null;
  /** Where the slider stands among them; null at the means. */
  between: Between | null;
  /** Films whose signals were solved, of the route's direction. */
  signals: SignalFilms | null;
  askForLine: () => void;
}

export function useTireModel(result: StudyResult, study: StudyDetail, route: StudyRoute, sight: Sight): TireModel {
  const { map } = result;
  const inputIndex = inputAt(result, route.input);
  const inputName = result.inputs[inputIndex]?.name ?? "";
  const noise = filmNoise(result);
  const rulers = useMemo(() => rulersOf(map ?? { theta_deg: [], phi_deg: [] }, map?.shape), [map]);
  const skins = useSurface(result, route.id);
  const [isAsked, setAsked] = useState(false);
  const isLineWanted = isAsked || sight.value !== null || sight.pin !== null;
  const line = useAsked(isLineWanted ? `${route.id} ${inputName}` : null, () => api.sections(route.id, inputName));
  const solved = line?.status === "ready" ? line.value : null;
  const between = useMemo(() => (solved === null || sight.value === null ? null : nodesAbout(solved, sight.value)), [solved, sight.value]);
  const signals = useMemo(() => signalFilms(result, study, route.direction), [result, study.document, route.direction]);
  const shown = useMemo(() => {
    const field = map == null ? null : fieldOf(map, { direction: route.direction, quantity: route.quantity, input: inputIndex }, noise);
    if (field === null) return null;
    const own = signals !== null && route.quantity === "signal" ? { ...field, scale: voltScale(signals.films) } : field;
    const there = keptOn(withStrain(own, between, route), sight.scale);
    const raster = rasterOf(there, rulers);
    return { field: there, raster, contours: contourLines(raster, there.scale) };
  }, [map, route.direction, route.quantity, inputIndex, noise, between, signals, sight.scale?.join()]);
  const surface = useMemo(() => movedBy(skins.surface, solved, between), [skins.surface, solved, between]);
  const layout = shownLayout(result, sight.layout);
  const coloured = route.quantity === "signal" ? signals : null;
  const films = useMemo(() => {
    if (coloured !== null) return signalPatches(coloured, route.direction, shown?.field.scale ?? voltScale(coloured.films));
    return layout === null ? [] : filmsOf(layout);
  }, [coloured, route.direction, shown, layout]);
  // Films that stand for themselves aren't mixed with the places of the ranking.
  const places = useMemo(() => (coloured === null ? locationMarks(result.cut_point.locations) : []), [result, coloured]);
  const filmSize = useMemo(() => coloured?.size ?? sizeOf(result), [result, coloured]);
  return {
    shown,
    rulers,
    places,
    films,
    filmSize,
    noise,
    layout,
    inputIndex,
    inputName,
    surface,
    isSector: skins.isSector,
    line,
    between,
    signals,
    askForLine: () => setAsked(true),
  };
}

function shownLayout(result: StudyResult, chosen: Sight["layout"]): RankedLayout | null {
  if (chosen === "answer") return answersLayout(result);
  return chosen === null ? null : (result.layouts[chosen] ?? null);
}

/** The wheel as it is drawn; the map's sector where the service sends no wheel. */
function useSurface(result: StudyResult, id: string): { surface: Loadable<Surface>; isSector: boolean } {
  const asked = useAsked(id, async (key) => readSurface(await api.surface(key)));
  return useMemo(() => {
    const { map } = result;
    if (asked?.status === "ready") {
      const sector: [number, number] = map == null ? [-45, 45] : [map.theta_deg[0] ?? -45, map.theta_deg[map.theta_deg.length - 1] ?? 45];
      return { surface: { status: "ready", value: drawnWheel(asked.value, sector) }, isSector: false };
    }
    const sector = asked?.status === "failed" && map != null ? sectorOf(map) : null;
    if (sector !== null) return { surface: { status: "ready", value: sector }, isSector: true };
    return { surface: asked ?? { status: "loading" }, isSector: false };
  }, [asked?.status, result]);
}

/** The input of the route, or the centre's own. */
function inputAt(result: StudyResult, name: string | null): number {
  const find = (wanted: string | null): number => result.inputs.findIndex((input) => input.name === wanted);
  const chosen = find(name);
  return chosen >= 0 ? chosen : Math.max(0, find(centreName(result)));
}

/** The strain where the slider stands, on the scale of the means. */
function withStrain(field: Field, between: Between | null, { quantity, direction }: StudyRoute): Field {
  return between === null || quantity !== "strain" ? field : { ...field, values: strainAt(between, direction) };
}

function movedBy(surface: Loadable<Surface>, line: Sections | null, between: Between | null): Loadable<Surface> {
  if (surface.status !== "ready" || line === null || between === null) return surface;
  const moved = movedSurface(surface.value, line, between);
  return moved === null ? surface : { status: "ready", value: moved };
}

export function sizeOf(result: StudyResult): PatchSize | null {
  const [length, width] = result.layout_findings?.size_mm ?? [];
  return length === undefined || width === undefined ? null : [length, width];
}
