/** The answer's sentences as the page shows them. */

import type { Answer, InputsAnswer, InputsBeside, LayoutAnswer, LeftOut, PlaceAnswer, StudyResult } from "../../../wire.ts";
import { duration, fixed, significant } from "../../format.ts";
import { filmCount, short } from "../../layouts/layout-words.ts";

/** With the signs of print for those of a terminal. */
export function typeset(sentence: string): string {
  return sentence
    .replaceAll("+-", "±")
    .replace(/(\d) degrees/g, "$1°")
    .replace(/(\d) mm\b/g, "$1\u00a0mm");
}

/** The first sentence, typeset: what more and fewer films give is drawn beside it. */
export function firstOf(sentences: string): string {
  return typeset(sentences).split(/(?<=\.) (?=[A-Z0-9])/, 1)[0] ?? "";
}

/** What a reason comes to, without its figures, which stand in the sentence above and in the plot: they follow a colon, or come first where the layout's own do. */
export function leadOf(reason: string): string {
  const [lead = "", rest] = typeset(reason).split(/: |(?<=\.) /, 2);
  const [own, fewer] = lead.split("; ", 2);
  if (own?.startsWith("It has ") === true && fewer !== undefined) return sentence(rest ?? fewer);
  return sentence(lead.replace(/^Of the layouts tried with up to \d+ films /, ""));
}

function sentence(words: string): string {
  return `${words.charAt(0).toUpperCase()}${words.slice(1)}${words.endsWith(".") ? "" : "."}`;
}

/** `film stiffness, 100 % of the strain`: what the model leaves out, and how much that would change. */
export function leftOutWords({ what, effect }: LeftOut): string {
  return `${what}, ${short(100 * effect, 2)} % of the strain`;
}

/** `P2, P4 in x, 72.9 ± 2.9 %`: the places with their index. */
export function placeWords({ names, direction, index, error }: PlaceAnswer): string {
  return `${names.join(", ")} in ${direction}, ${percent(index, error)}`;
}

/** `72.9 ± 2.9 %`; the figure alone where its error is unknown, or below its last decimal. */
function percent(share: number, error: number | null | undefined): string {
  const off = error == null ? "" : fixed(100 * error, 1);
  return `${fixed(100 * share, 1)} ${Number(off) === 0 ? "" : `± ${off} `}%`;
}

/** Inputs named before the rest is left to the matrix. */
const MATTERING = 3;

/** `cords 39.0 ± 1.2 %, P3 30.1 ± 0.8 %, P2 9.9 ± 0.8 % of y at P3`: the inputs that matter most. */
export function inputWords({ shares, direction, location }: InputsAnswer): string {
  const words = shares.slice(0, MATTERING).map(({ input, index, error }) => `${input} ${percent(index, error)}`);
  return `${words.join(", ")} of ${direction} at ${location}`;
}

/** Whether inputs vary that aren't depths below the places, which a ranking of places doesn't show. */
export function beyondPlaces({ shares }: InputsAnswer, { locations }: Pick<StudyResult, "locations">): boolean {
  return shares.length > locations.length;
}

/** `1.27° rms; noise alone 0.274°`, `pressure 81 %, P3 12 % of 3.10 V`: what the inputs do to another quantity than a strain. */
export function besideWords({ shares, std, unit }: InputsBeside): string {
  const noise = shares.find(({ input }) => input === "noise");
  if (noise !== undefined) return `${significant(std)}° rms; noise alone ${significant(std * Math.sqrt(noise.index))}°`;
  const words = shares.slice(0, MATTERING).map(({ input, index }) => `${input} ${fixed(100 * index, 0)} %`);
  return `${words.join(", ")} of ${significant(std)} ${unit}`;
}

/** `reference mesh, about 32 s`: what a surer answer costs. */
export function surerWords({ level, times, expected_s }: NonNullable<Answer["surer"]>): string {
  const work = times == null ? "" : `, ${short(times, 2)} times the work`;
  return `${level} mesh${expected_s == null ? work : `, about ${duration(expected_s)}`}`;
}

/** Ranks named before the rest is counted. */
const NAMED = 3;

/** `12 films, level with rank 2, 5`: how the answer's layout stands. */
export function layoutStanding({ film_count, tied_with }: LayoutAnswer): string {
  const count = filmCount(film_count);
  if (tied_with.length === 0) return count;
  const more = tied_with.length > NAMED ? ` and ${tied_with.length - NAMED} more` : "";
  return `${count}, level with rank ${tied_with.slice(0, NAMED).join(", ")}${more}`;
}

/** What a study that ranks nothing tells. */
export function unrankedWords({ inputs, signals, layouts }: Pick<StudyResult, "inputs" | "signals" | "layouts">): string {
  const names = inputs.map(({ name }) => name).join(", ");
  const tells =
    signals != null
      ? "what films read"
      : layouts.length > 0
        ? "bounds of layouts"
        : `how much ${names} ${inputs.length === 1 ? "changes" : "change"} the strain at each place`;
  return `This study ranks no place and no layout. It tells ${tells}.`;
}
