import { address } from "../../api.ts";
import { asksForLayouts } from "../../lib/layouts/film-criteria.ts";
import type { Route, StudyRoute } from "../../lib/route.ts";
import type { StudyResult, Trade } from "../../wire.ts";
import { Notes } from "../shared/notes-panel.tsx";
import { CostPanel } from "./cost-panel.tsx";
import { FailedPoints } from "./failed-points.tsx";
import { LayoutsPanel } from "./layouts/layouts-panel.tsx";
import { MapPanel } from "./map/map-panel.tsx";
import { MatrixPanel } from "./matrix-panel.tsx";
import { ModelPanel } from "./model-panel.tsx";
import { RankingPanel } from "./ranking/ranking-panel.tsx";
import { SignalsPanel } from "./signals/signals-panel.tsx";
import { TradePanel } from "./trade-panel.tsx";

/** Tables that the service exports. */
const TABLES = ["indices", "locations", "layouts", "candidates", "points", "signals"] as const;

/** Formats that they are exported in. */
const FILES = [{ format: "csv", label: "CSV" }, { format: "parquet", label: "Parquet" }] as const;

/** The answer of a study, most important first. */
export function ResultPanels(props: {
  result: StudyResult;
  trade: Trade | null;
  route: StudyRoute;
  onAdjust: (route: Route) => void;
}) {
  const { result, trade, route, onAdjust } = props;
  const { id, version, spec_sha256 } = result.study;
  const layouts = <LayoutsPanel layouts={result.layouts} findings={result.layout_findings ?? null} />;
  const areLayoutsFirst = asksForLayouts(result);
  return (
    <>
      <p class="provenance">
        {version} · document <code title={spec_sha256}>{spec_sha256.slice(0, 12)}</code> · as JSON:{" "}
        <a href={address(id, "result")}>the whole result</a>, <a href={address(id, "evaluations")}>every solved point</a>
        {FILES.map(({ format, label }) => (
          <>
            {" · "}as {label}:{" "}
            {TABLES.map((table, k) => (
              <>
                {k > 0 && ", "}
                <a href={address(id, `export?format=${format}&table=${table}`)}>{table}</a>
              </>
            ))}
          </>
        ))}
        {result.map?.shape && (
          <>
            {" "}· for ParaView: <a href={address(id, "export?format=vtu")}>the map</a>
          </>
        )}
      </p>
      <Notes notes={result.notes} />
      <FailedPoints result={result} />
      {areLayoutsFirst && layouts}
      <RankingPanel result={result} />
      {result.signals != null && <SignalsPanel signals={result.signals} />}
      <MapPanel result={result} route={route} onAdjust={onAdjust} />
      <MatrixPanel result={result} />
      {!areLayoutsFirst && layouts}
      <ModelPanel result={result} />
      <CostPanel cost={result.cost} estimate={result.estimate ?? null} />
      {trade !== null && <TradePanel trade={trade} />}
    </>
  );
}
