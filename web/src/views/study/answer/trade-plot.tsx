import { frameOf, upwards } from "../../../lib/chart/frame.ts";
import { log, logTicks } from "../../../lib/chart/scales.ts";
import { errorsOf, filmTrade, type FilmTrade } from "../../../lib/layouts/film-trade.ts";
import { short } from "../../../lib/layouts/layout-words.ts";
import { unitTicks } from "../../../lib/layouts/layout-curves.ts";
import { Axis } from "../../shared/chart/axis.tsx";
import { Chart } from "../../shared/chart/chart.tsx";
import { Curve } from "../../shared/chart/marks.tsx";
import type { TradeAnswer } from "../../../wire.ts";

const FRAME = frameOf(350, 160, { left: 44, right: 10, top: 8, bottom: 36 });
/** Outermost points stand so far from the axes. */
const INDENT = 14;
/** From one number below the axis to the next, at least. */
const APART = 44;

/** The error of the best layout of each number of films, both logarithmic; what is asked and the layout that answers are marked. */
export function TradePlot({ trade }: { trade: TradeAnswer }) {
  const drawn = filmTrade(trade);
  const { points, title, limit, films } = drawn;
  if (points.length < 2) return null;
  const counts = points.map(({ row }) => row.film_count).concat(films ?? []);
  const x = log([Math.min(...counts), Math.max(...counts)], [FRAME.left + INDENT, FRAME.right - INDENT]);
  const y = log(errorsOf(drawn), upwards(FRAME)).clamp(true);
  const picked = points.find(({ is_picked }) => is_picked);
  return (
    <Chart class="trade-plot" frame={FRAME} label={labelOf(drawn)}>
      <Axis side="left" frame={FRAME} {...logTicks(y, [1])} title={title} />
      <Axis side="bottom" frame={FRAME} values={unitTicks(counts, picked?.row.film_count ?? 0, x, APART)} at={x} text={String} title="films" />
      {limit !== null && <path class="asked-line" d={`M${FRAME.left} ${y(limit)}H${FRAME.right}`} />}
      {films !== null && <path class="asked-line" d={`M${x(films)} ${FRAME.top}V${FRAME.bottom}`} />}
      <Curve
        class="layout-curve place-0"
        radius={3}
        values={points.map(({ row, error, low, high, title }) => ({ at: [x(row.film_count), y(error)], ends: [y(low), y(high)], title }))}
      />
      {picked !== undefined && (
        <circle class="picked-mark" cx={x(picked.row.film_count)} cy={y(picked.error)} r={8}>
          <title>{picked.title}</title>
        </circle>
      )}
    </Chart>
  );
}

function labelOf({ points, title, limit, films, unit }: FilmTrade): string {
  const asked = [films === null ? "" : `${films} films`, limit === null ? "" : `${short(limit)}${unit}`].filter((text) => text !== "");
  const picked = points.find(({ is_picked }) => is_picked);
  const parts = [`Films against ${title}: the best layout of each number of films`, ...asked.map((text) => `asked: ${text}`), picked?.title ?? ""];
  return parts.filter((part) => part !== "").join("; ");
}
