import { formatRoute } from "../../../lib/route.ts";
import type { StudyDetail } from "../../../wire.ts";
import type { SectionProps } from "../section-props.ts";
import { CostPanel } from "./cost-panel.tsx";
import { DocumentPanel } from "./document-panel.tsx";
import { FailedPoints } from "./failed-points.tsx";
import { FilesPanel } from "./files-panel.tsx";
import { ModelPanel } from "./model-panel.tsx";

/** What was modelled, what it took, and all of it as files. */
export function RunView({ result, study, route }: SectionProps) {
  return (
    <>
      <FailedPoints result={result} />
      <ModelPanel result={result} />
      <CostPanel cost={result.cost} estimate={result.estimate ?? null} />
      <FilesPanel result={result} hasMap={hasMap(study)} sheet={formatRoute({ ...route, section: "sheet" })} />
      <DocumentPanel study={study} />
    </>
  );
}

/** The result is here without its map; the document says whether there is one. */
function hasMap({ document }: StudyDetail): boolean {
  const { candidates } = document as { candidates?: { grid?: unknown } | null };
  return candidates?.grid != null;
}
