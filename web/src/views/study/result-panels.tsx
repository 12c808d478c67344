import { address } from "../../api.ts";
import type { Route } from "../../lib/route.ts";
import type { StudyResult, Trade } from "../../types.ts";
import { CostView } from "./cost-panel.tsx";
import { FailedPoints } from "./failed-points.tsx";
import { LayoutsView } from "./layouts-panel.tsx";
import { MapView } from "./map/map-panel.tsx";
import { MatrixView } from "./matrix-panel.tsx";
import { ModelView } from "./model-panel.tsx";
import { Notes } from "../shared/notes.tsx";
import { RankingView } from "./ranking/ranking-panel.tsx";
import { TradeView } from "./trade-panel.tsx";

/** Tables that the service exports. */
const TABLES = ["indices", "locations", "layouts", "points"] as const;

/** Formats that they are exported in. */
const FILES = [{ format: "csv", label: "CSV" }, { format: "parquet", label: "Parquet" }] as const;

type StudyRoute = Extract<Route, { view: "study" }>;

/** The answer of a study, most important first. */
export function ResultView(props: {
  result: StudyResult;
  trade: Trade | null;
  route: StudyRoute;
  onAdjust: (route: Route) => void;
}) {
  const { result, trade, route, onAdjust } = props;
  const { id, version, spec_sha256 } = result.study;
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
      <RankingView result={result} />
      <MapView result={result} route={route} onAdjust={onAdjust} />
      <MatrixView result={result} />
      <LayoutsView layouts={result.layouts} />
      <ModelView result={result} />
      <CostView cost={result.cost} estimate={result.estimate ?? null} />
      {trade !== null && <TradeView trade={trade} />}
    </>
  );
}
