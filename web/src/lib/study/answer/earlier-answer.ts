/** A modest answer from the ranks of a result that has none of its own. */

import type { Answer, Certainty, LayoutAnswer, LeftOut, PlaceAnswer, RankedLayout, RankedLocation, StudyResult } from "../../../wire.ts";
import { layoutWords, LOST_DEG, short } from "../../layouts/layout-words.ts";
import { byRank } from "../result-picks.ts";

/** From weak to strong. */
const CERTAINTIES: readonly Certainty[] = ["unknown", "tied", "likely", "certain"];

/** Null where the study ranks nothing. What ranks certainly is certain, all else unknown: the page has no errors to judge by. */
export function earlierAnswer(result: StudyResult): Answer | null {
  const [place, layout] = [placeOf(byRank(result)), layoutOf(result.layouts)];
  const first = layout ?? place;
  if (first === null) return null;
  const parts = [place, layout].filter((part) => part !== null);
  const weakest = parts.reduce((weak, part) => (strength(part) < strength(weak) ? part : weak), first);
  return {
    sentence: layout === null ? (place as PlaceAnswer).sentence : layoutSentence(layout),
    verdict: weakest.verdict,
    reason: weakest.reason,
    place,
    layout,
    left_out: leftOut(result),
    surer: null,
  };
}

const strength = ({ verdict }: { verdict: Certainty }): number => CERTAINTIES.indexOf(verdict);

function placeOf(ranked: RankedLocation[]): PlaceAnswer | null {
  const best = ranked[0];
  const [x, y] = [best?.gsi_x_percent ?? null, best?.gsi_y_percent ?? null];
  if (best === undefined || best.input == null || (x === null && y === null)) return null;
  const direction = (x ?? -1) >= (y ?? -1) ? "x" : "y";
  const names = ranked.filter(({ rank }) => rank === best.rank).map(({ name }) => name);
  const percent = Math.max(x ?? 0, y ?? 0);
  const error = best[`gsi_${direction}_error_percent`];
  const told = names.length > 1 ? `${names.join(", ")} share the first rank` : `${best.name} ranks first`;
  return {
    names,
    direction,
    index: percent / 100,
    error: error == null ? null : error / 100,
    verdict: best.rank_certain ? "certain" : "unknown",
    reason: `${told}${best.rank_certain ? "; the errors leave no doubt." : ", but the errors leave doubt."}`,
    sentence: `Glue films of ${direction} at ${names.join(" or ")}: ${short(percent)} % of the variation at the centre is told there.`,
  };
}

function layoutOf(layouts: RankedLayout[]): LayoutAnswer | null {
  const best = layouts.find(({ rank }) => rank === 1);
  const angle_error_deg = best?.score.simulated_p95_angle_error_deg;
  if (best === undefined || angle_error_deg == null) return null;
  const isCertain = best.rank_certain === true && angle_error_deg <= LOST_DEG;
  return {
    rank: best.rank,
    words: layoutWords(best),
    units: best.units,
    film_count: best.film_count ?? best.units,
    angle_error_deg,
    error_deg: best.score.error?.simulated_p95_angle_error_deg ?? null,
    tied_with: [],
    verdict: isCertain ? "certain" : "unknown",
    reason: layoutReason(isCertain, angle_error_deg),
  };
}

function layoutReason(isCertain: boolean, angle_error_deg: number): string {
  if (isCertain) return "The layout ranks first without doubt.";
  if (angle_error_deg > LOST_DEG) return `No layout finds the contact to ${LOST_DEG}°.`;
  return "The layout ranks first, but the errors leave doubt.";
}

function layoutSentence({ words, angle_error_deg, error_deg }: LayoutAnswer): string {
  const error = error_deg == null ? "" : ` ± ${short(error_deg, 2)}`;
  return `Glue ${words}: they know the contact angle to ${short(angle_error_deg, 2)}${error}° at the worst load.`;
}

function leftOut({ model }: StudyResult): LeftOut | null {
  const known = model.left_out.flatMap(({ what, why, effect }) => (effect == null ? [] : [{ what, why, effect }]));
  const largest = known.reduce<(typeof known)[number] | null>((most, each) => (each.effect > (most?.effect ?? 0) ? each : most), null);
  if (largest === null) return null;
  const percent = short(100 * largest.effect, 2);
  return { ...largest, sentence: `${largest.what.charAt(0).toUpperCase()}${largest.what.slice(1)}: it would change the strain by ${percent} %.` };
}
