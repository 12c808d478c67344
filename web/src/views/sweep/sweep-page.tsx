import { useMemo } from "preact/hooks";
import { comparisonAddress, comparisonExport, sweepAddress } from "../../api.ts";
import type { SweepRoute } from "../../lib/route.ts";
import { variedPaths } from "../../lib/sweep/design-progress.ts";
import type { Actions } from "../../state/actions.ts";
import type { AppState } from "../../state/app-state.ts";
import type { Loadable } from "../../state/loadable.ts";
import type { Comparison, DesignView, SweepDetail } from "../../wire.ts";
import { Loaded } from "../shared/loaded.tsx";
import { StateBadge } from "../shared/state-badge.tsx";
import { ComparisonPanel } from "./comparison-panel.tsx";
import { DesignTable } from "./design-table.tsx";
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
  return (
    <Loaded of={open.detail} what="the sweep" onRetry={actions.openSweep.reopen}>
      {(sweep) => (
        <article class="study">
          <header class="study-head">
            <h1>{sweep.name}</h1>
            <StateBadge state={sweep.state} />
          </header>
          <p class="provenance">
            as JSON: <a href={sweepAddress(sweep.id)}>the sweep</a>,{" "}
            <a href={comparisonAddress(sweep.id, route.baseline)}>the comparison</a>; its locations as{" "}
            <a href={comparisonExport(sweep.id, route.baseline, "format=csv")}>CSV</a> or{" "}
            <a href={comparisonExport(sweep.id, route.baseline, "format=parquet")}>Parquet</a>, its designs as{" "}
            <a href={comparisonExport(sweep.id, route.baseline, "format=csv&table=designs")}>CSV</a>
          </p>
          <SweepProgress open={open} sweep={sweep} now_ms={state.now_ms} actions={actions} />
          <Designs sweep={sweep} comparison={open.comparison} />
          {open.comparison !== null && (
            <Loaded of={open.comparison} what="the comparison" onRetry={actions.openSweep.reopen}>
              {(comparison) => (
                <ComparisonPanel comparison={comparison} designs={sweep.designs} route={route} onAdjust={actions.adjust} />
              )}
            </Loaded>
          )}
        </article>
      )}
    </Loaded>
  );
}

function Designs({ sweep, comparison }: { sweep: SweepDetail; comparison: Loadable<Comparison> | null }) {
  const compared = comparison?.status === "ready" ? comparison.value : null;
  // The page's clock ticks every second, the table needn't.
  const table = useMemo(() => <DesignTable designs={sweep.designs} comparison={compared} />, [sweep.designs, compared]);
  return (
    <section class="panel" aria-labelledby="designs-title">
      <h2 id="designs-title">Designs</h2>
      <VariedPaths designs={sweep.designs} />
      {table}
      <p class="quiet">
        Force: vertical, at the means of the inputs. Signal: standard deviation of the strain at the centre, in microstrain (µε, 10⁻⁶), x circumferential
        and y meridional. Best: the first of the ranking, and whether its errors leave no doubt about that. Each design links to its study.
      </p>
    </section>
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
