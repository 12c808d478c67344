import { useMemo } from "preact/hooks";
import * as api from "../../../api.ts";
import { differenceField, hasDifferences, onOneScale } from "../../../lib/compare/difference-field.ts";
import type { CompareRoute } from "../../../lib/route.ts";
import { centreName } from "../../../lib/study/result-picks.ts";
import { rulersOf } from "../../../lib/tire/map/arc-length.ts";
import { contourLines, zeroLines } from "../../../lib/tire/map/contour-lines.ts";
import { rasterOf } from "../../../lib/tire/map/field-raster.ts";
import { fieldOf, filmNoise, keptOn, locationMarks, type Field } from "../../../lib/tire/map/surface-field.ts";
import type { Sight } from "../../../lib/tire/view-address.ts";
import { answerTo, type Loadable } from "../../../state/loadable.ts";
import { useAsked } from "../../../state/use-asked.ts";
import type { StudyResult } from "../../../wire.ts";
import type { MapModel } from "../../study/tire/tire-model.ts";

/** One of the studies with its layer. */
export interface ComparedLayer {
  id: string;
  /** Counted from one, as everywhere on the page. */
  number: number;
  name: string;
  /** Null without such a layer; `why` then says so. */
  map: (MapModel & { shown: NonNullable<MapModel["shown"]> }) | null;
  why: string | null;
  /** Against the baseline; null in it, and where there is none. */
  difference: ComparedLayer["map"];
}

/** The results with their maps, each by itself: one that fails leaves the others. */
export function useResults(studies: readonly string[]): Loadable<StudyResult>[] {
  const asked = useAsked(studies.join(), (key) => Promise.all(key.split(",").map((id) => answerTo(api.result(id, true)))));
  return asked?.status === "ready" ? asked.value : studies.map(() => ({ status: "loading" }));
}

/** The input of the address, or the centre's own of the first study. */
export function inputNames(results: readonly StudyResult[]): string[] {
  return [...new Set(results.flatMap(({ inputs }) => inputs.map(({ name }) => name)))];
}

export function inputOf(route: CompareRoute, results: readonly StudyResult[]): string {
  const [first] = results;
  return route.input ?? (first === undefined ? null : centreName(first)) ?? "";
}

/** Maps that can be read side by side. */
const MOST_DRAWN = 4;

/** Studies whose maps are drawn: the first ones, the baseline among them. */
export function drawnOf(studies: readonly string[], baseline: string | null): string[] {
  const first = studies.slice(0, MOST_DRAWN);
  if (baseline === null || first.includes(baseline) || !studies.includes(baseline)) return first;
  return [baseline, ...first.slice(0, MOST_DRAWN - 1)];
}

/** Every study's layer on one scale, and its difference from the baseline's on another. */
export function useLayers(
  route: CompareRoute,
  studies: readonly string[],
  answers: readonly Loadable<StudyResult>[],
  baseline: string | null,
  scale: Sight["scale"],
): ComparedLayer[] {
  const { direction, quantity } = route;
  return useMemo(() => {
    const ready = answers.flatMap((answer) => (answer.status === "ready" ? [answer.value] : []));
    const input = inputOf(route, ready);
    const fields = answers.map((answer) => (answer.status === "ready" ? layerOf(answer.value, route, input) : null));
    const there = fields.filter((field) => field !== null);
    const together = onOneScale(there).map((field) => keptOn(field, scale));
    const scaled = fields.map((field) => (field === null ? null : (together[there.indexOf(field)] ?? null)));
    const base = scaled[studies.indexOf(baseline ?? "")] ?? null;
    const differences = scaled.map((field, k) =>
      field === null || base === null || studies[k] === baseline || !hasDifferences(field) ? null : differenceField(field, base),
    );
    const apart = onOneScale(differences.filter((field) => field !== null));
    let next = 0;
    return answers.map((answer, k): ComparedLayer => {
      const [field, difference] = [scaled[k] ?? null, differences[k] == null ? null : (apart[next++] ?? null)];
      const result = answer.status === "ready" ? answer.value : null;
      return {
        id: studies[k] ?? "",
        number: route.studies.indexOf(studies[k] ?? "") + 1,
        name: result?.study.name ?? "",
        why: whyNot(answer, field),
        map: result === null || field === null ? null : drawn(result, field),
        difference: result === null || difference === null ? null : drawn(result, difference),
      };
    });
  }, [studies.join(), direction, quantity, route.input, baseline, answers, scale?.join()]);
}

function layerOf(result: StudyResult, { direction, quantity }: CompareRoute, name: string): Field | null {
  const input = result.inputs.findIndex((each) => each.name === name);
  const isOfInput = quantity === "index" || quantity === "total" || quantity === "error";
  if (result.map == null || (isOfInput && input < 0)) return null;
  return fieldOf(result.map, { direction, quantity, input: Math.max(0, input) }, filmNoise(result));
}

function whyNot(answer: Loadable<StudyResult>, field: Field | null): string | null {
  if (answer.status === "failed") return answer.problem.detail ?? answer.problem.title;
  if (answer.status === "loading" || field !== null) return null;
  return answer.value.map == null ? "This study asked for no map." : "This study's map doesn't have this layer.";
}

/** A field as map and tire draw it; of a difference only the line of zero is drawn, wherever it runs. */
function drawn(result: StudyResult, field: Field): NonNullable<ComparedLayer["map"]> {
  const rulers = rulersOf(field, result.map?.shape);
  const raster = rasterOf(field, rulers);
  const contours = field.quantity === "difference" ? zeroLines(raster) : contourLines(raster, field.scale);
  return { shown: { field, raster, contours }, rulers, places: locationMarks(result.cut_point.locations), films: [], filmSize: null };
}
