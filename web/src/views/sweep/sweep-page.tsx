import { useMemo } from "preact/hooks";
import { comparisonAddress, comparisonExport, DESIGNS_OF_A_PAGE, sweepAddress } from "../../api.ts";
import { integer } from "../../lib/format.ts";
import { compareRoute, formatRoute, type SweepRoute } from "../../lib/route.ts";
import { designsOf, variedPaths } from "../../lib/sweep/design-progress.ts";
import { designGrid } from "../../lib/sweep/figure-grid.ts";
import type { Actions } from "../../state/actions.ts";
import type { AppState } from "../../state/app-state.ts";
import { isMissing, type Loadable } from "../../state/loadable.ts";
import type { Comparison, DesignView, SweepDetail } from "../../wire.ts";
import { Loaded } from "../shared/loaded.tsx";
import { StateBadge } from "../shared/state-badge.tsx";
import { Removed } from "../shell/missing.tsx";
import { AnswersPanel } from "./answers-panel.tsx";
import { ComparisonPanel } from "./comparison-panel.tsx";
import { DesignTable, type Ticking } from "./design-table.tsx";
import { FigureGridPanel } from "./figure-grid-panel.tsx";
import { SweepProgress } from "./sweep-progress.tsx";

interface Props {
  state: AppState;
  route: SweepRoute;
  actions: Actions;
}

/** One sweep: how far it is, its designs, and what differs between them. */
export function SweepPage({ state, route, actions }: Props) {
  const open = state.openSweep;
  if (open === null) return <p class="quiet">Loading the sweep …</p>;
  if (isMissing(open.detail)) return <Removed what="Sweep" problem={open.detail.problem} />;
  return (
    <Loaded of={open.detail} what="the sweep" onRetry={actions.openSweep.reopen}>
      {(sweep) => (
        <article>
          <header class="study-head">
            <h1>{sweep.name}</h1>
            <StateBadge state={sweep.state} />
          </header>
          <p class="provenance">
            as JSON: <a href={sweepAddress(sweep.id)}>the sweep</a>, <a href={comparisonAddress(sweep.id, route.baseline)}>the comparison</a>; its locations as{" "}
            <a href={comparisonExport({ sweep: sweep.id }, route.baseline, "format=csv")}>CSV</a> or{" "}
            <a href={comparisonExport({ sweep: sweep.id }, route.baseline, "format=parquet")}>Parquet</a>, its designs as{" "}
            <a href={comparisonExport({ sweep: sweep.id }, route.baseline, "format=csv&table=designs")}>CSV</a>
          </p>
          <SweepProgress open={open} sweep={sweep} actions={actions} />
          {open.comparison !== null && (
            <Loaded of={open.comparison} what="the comparison" onRetry={actions.openSweep.reopen}>
              {(comparison) => <AnswersPanel comparison={comparison} csv={comparisonExport({ sweep: sweep.id }, route.baseline, "format=csv&table=designs")} />}
            </Loaded>
          )}
          <Grid sweep={sweep} comparison={readyOf(open.comparison)} route={route} actions={actions} />
          <Designs sweep={sweep} route={route} comparison={readyOf(open.comparison)} ticked={state.browsing.ticked} onTick={actions.browsing.tick} />
          {open.comparison !== null && (
            <Loaded of={open.comparison} what="the comparison" onRetry={actions.openSweep.reopen}>
              {(comparison) => (
                <ComparisonPanel
                  comparison={comparison}
                  shown={route.shown}
                  onBaseline={(baseline) => actions.adjust({ ...route, baseline })}
                  onShown={(shown) => actions.adjust({ ...route, shown })}
                />
              )}
            </Loaded>
          )}
        </article>
      )}
    </Loaded>
  );
}

function readyOf(comparison: Loadable<Comparison> | null): Comparison | null {
  return comparison?.status === "ready" ? comparison.value : null;
}

/** The grid of two fields; other sweeps are lists. */
function Grid({ sweep, comparison, route, actions }: { sweep: SweepDetail; comparison: Comparison | null; route: SweepRoute; actions: Actions }) {
  const grid = useMemo(() => designGrid(sweep.designs), [sweep.designs]);
  if (grid === null) return null;
  return <FigureGridPanel grid={grid} comparison={comparison} figure={route.figure} onFigure={(figure) => actions.adjust({ ...route, figure })} />;
}

interface DesignsProps extends Ticking {
  sweep: SweepDetail;
  route: SweepRoute;
  comparison: Comparison | null;
}

function Designs({ sweep, route, comparison, ticked, onTick }: DesignsProps) {
  // The page's clock ticks every second, the table needn't.
  const table = useMemo(
    () => <DesignTable designs={sweep.designs} comparison={comparison} ticked={ticked} onTick={onTick} />,
    [sweep.designs, comparison, ticked],
  );
  return (
    <section class="panel" aria-labelledby="designs-title">
      <h2 id="designs-title">Designs</h2>
      <VariedPaths designs={sweep.designs} />
      <Pages sweep={sweep} route={route} />
      {table}
      {ticked.length > 0 && (
        <p class="compare-ticked">
          {ticked.length === 1 ? (
            "Tick another design or study to compare."
          ) : (
            <a href={formatRoute(compareRoute([...ticked]))}>Compare the {ticked.length} ticked</a>
          )}
        </p>
      )}
      <p class="quiet">
        Force: vertical, at the means of the inputs. Signal: standard deviation of the strain at the centre, in microstrain (µε, 10⁻⁶), x circumferential and y
        meridional. Best: the first of the ranking, and whether its errors leave no doubt about that. Each design links to its study.
      </p>
    </section>
  );
}

/** Which of many designs are shown, with links to those before and behind them; nothing where all are. */
function Pages({ sweep, route }: { sweep: SweepDetail; route: SweepRoute }) {
  const [all, shown] = [designsOf(sweep), sweep.designs.length];
  if (shown === all) return null;
  const at = (from: number, name: string) => <a href={formatRoute({ ...route, from })}>{name}</a>;
  const end = route.from + shown;
  return (
    <nav aria-label="Pages of designs">
      Designs {integer(route.from + 1)} to {integer(end)} of {integer(all)}
      {route.from > 0 && <> · {at(Math.max(0, route.from - DESIGNS_OF_A_PAGE), "before")}</>}
      {end < all && <> · {at(end, "next")}</>}. What is compared are the best {integer(DESIGNS_OF_A_PAGE)}; the files have them all.
    </nav>
  );
}

/** Values that are worth listing; more are told by their number. */
const MOST_LISTED = 12;

function VariedPaths({ designs }: { designs: DesignView[] }) {
  const varied = variedPaths(designs);
  if (varied.length === 0) return null;
  return (
    <p>
      Varied:{" "}
      {varied.map(({ path, values }, index) => (
        <span key={path}>
          {index > 0 && "; "}
          <code>{path}</code> {values.length > MOST_LISTED ? `${values.length} values` : values.join(", ")}
        </span>
      ))}
    </p>
  );
}
