import type { Route, StudyRoute } from "../../lib/route.ts";
import type { StudyDetail, StudyResult, Trade } from "../../wire.ts";

/** What every section of a study's page is drawn from. */
export interface SectionProps {
  study: StudyDetail;
  /** Its map is null but in the section that shows it. */
  result: StudyResult;
  trade: Trade | null;
  route: StudyRoute;
  onAdjust: (route: Route) => void;
}
