/** Ranks of layouts in several studies beside the baseline's. The studies rank; nothing here does. */

import type { RankedLayout } from "../../wire.ts";
import { rankWords } from "../format.ts";
import { layoutWords } from "../layouts/layout-words.ts";

/** A layout in one study. */
export interface LayoutRank {
  /** `2=` where several share it. */
  words: string;
  rank: number;
  isCertain: boolean;
  /** Places lost since the baseline, negative when gained; null unless the errors leave no doubt about either rank. */
  change: number | null;
}

/** A layout in all of them; null where a study hasn't scored it. */
interface RankedRow {
  layout: string;
  ranks: (LayoutRank | null)[];
}

/** The first layouts of every study, in the order of the baseline's ranks. */
export function layoutRanks(studies: readonly (readonly RankedLayout[])[], baseline: number, most: number): RankedRow[] {
  const named = studies.map((layouts) => new Map(layouts.map((layout) => [layoutWords(layout), layout])));
  const base = named[baseline] ?? new Map<string, RankedLayout>();
  const names = new Set([...named.keys()].flatMap((k) => [...(named[k]?.entries() ?? [])].filter(([, { rank }]) => rank <= most).map(([name]) => name)));
  const rankOf = (name: string): number => base.get(name)?.rank ?? Number.POSITIVE_INFINITY;
  return [...names]
    .sort((a, b) => (rankOf(a) === rankOf(b) ? 0 : rankOf(a) - rankOf(b)))
    .map((layout) => ({
      layout,
      ranks: named.map((layouts, k) => rankIn(layouts.get(layout), studies[k] ?? [], k === baseline ? undefined : base.get(layout))),
    }));
}

function rankIn(layout: RankedLayout | undefined, all: readonly RankedLayout[], base: RankedLayout | undefined): LayoutRank | null {
  if (layout === undefined) return null;
  const isCertain = layout.rank_certain === true;
  const change = isCertain && base?.rank_certain === true ? layout.rank - base.rank : null;
  return { words: rankWords(layout.rank, all), rank: layout.rank, isCertain, change };
}
