/** How good moved films are beside the layout that they were, in a sentence. */

import { short } from "../layout-words.ts";

/** Changes of less are none, relative. */
const SAME = 1e-9;

/** Of worst bounds of the contact angle, degrees; infinite where it can't be told, null where it isn't known. */
export function comparedWords(now: number, before: number | null): string {
  const told = Number.isFinite(now)
    ? `At its worst load and angle the contact is known to ${short(now, 2)}° at best`
    : "There is a contact that these films can't tell";
  return `${told}${before === null ? "" : `: ${changeWords(now, before)}`}.`;
}

function changeWords(now: number, before: number): string {
  const was = Number.isFinite(before) ? `the ${short(before, 2)}° of the layout it came from` : "the layout it came from, which can't tell all contacts";
  if (now === before) return "as the layout it came from";
  if (!Number.isFinite(now)) return `worse than ${was}`;
  if (!Number.isFinite(before)) return `better than ${was}`;
  const change = now / before - 1;
  if (Math.abs(change) <= SAME) return "as the layout it came from";
  return `${change < 0 ? "better" : "worse"} by ${short(100 * Math.abs(change), 2)} % than ${was}`;
}
