/** Trades of several studies on one plot. */

import type { ComparedStudy } from "../../wire.ts";
import { filmTrade, type FilmTrade } from "../layouts/film-trade.ts";

/** As many as have a colour of their own. */
const COLOURED = 6;

interface ComparedTrade {
  id: string;
  name: string;
  /** Class of its curve: the best have colours. */
  kind: string;
  isColoured: boolean;
  trade: FilmTrade;
}

/** Studies with a layout, best first. */
export function answered(studies: readonly ComparedStudy[]): ComparedStudy[] {
  const rankOf = ({ answer }: ComparedStudy): number => answer?.rank ?? 0;
  return studies.filter(({ answer }) => answer != null).sort((a, b) => rankOf(a) - rankOf(b));
}

/** The error of the angle over the number of films of each study, best first; the layout by which it is compared is picked. */
export function comparedTrades(studies: readonly ComparedStudy[]): ComparedTrade[] {
  return answered(studies).flatMap(({ id, name, answer }, k) => {
    if (answer == null) return [];
    const rows = answer.trade;
    const picked = rows.findIndex(({ rank }) => rank === answer.layout_rank);
    const trade = filmTrade({ question: {}, rows, picked });
    const isColoured = k < COLOURED;
    return [{ id, name, isColoured, kind: isColoured ? `layout-curve place-${k}` : "layout-curve others", trade }];
  });
}
