import type { Route } from "../../route.ts";

/** What is in view, as far as it has come. */
export interface Titled {
  /** Null before it is known, and of pages that have no name of their own. */
  name: string | null;
  /** `30 films along x`: the layout that a study answers with. */
  answer: string | null;
  /** The service has nothing of this identifier. */
  isMissing: boolean;
}

const KINDS: Record<Route["view"], string> = {
  home: "New study",
  study: "Study",
  sweep: "Sweep",
  compare: "Compare studies",
  forces: "Forces",
  estimator: "Estimator",
  own: "Your model",
  nowhere: "Page not found",
};

/** `wall 2.5 mm: 30 films along x - strainsite`: what the browser's tabs and history say of a page. */
export function pageTitle(route: Route, { name, answer, isMissing }: Titled): string {
  return `${isMissing ? `${KINDS[route.view]} not found` : opened(route, name, answer)} - strainsite`;
}

function opened(route: Route, name: string | null, answer: string | null): string {
  if (route.view === "compare" && route.studies.length > 1) return `Comparison of ${route.studies.length} studies`;
  if (name === null) return KINDS[route.view];
  const part = route.view !== "study" ? null : route.section === "answer" ? answer : route.section;
  return part === null ? name : `${name}: ${part}`;
}
