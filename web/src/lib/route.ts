import type { Direction } from "./direction.ts";

/** The view in the address bar: what a link shows is what its sender saw. */


/** What the map of the inner surface shows. */
export type Quantity = "index" | "std" | "strain" | "error";

export const QUANTITIES: readonly Quantity[] = ["index", "std", "strain", "error"];

/** What the charts of a sweep show: the indices, or how they differ from the baseline's. */
export type Shown = "index" | "difference";

export type HomeRoute = { view: "home"; preset: string | null };
export type SweepRoute = { view: "sweep"; id: string; baseline: string | null; shown: Shown };
export type StudyRoute = { view: "study"; id: string; direction: Direction; quantity: Quantity; input: string | null };
export type Route = HomeRoute | SweepRoute | StudyRoute;

/** Reads `#/studies/{id}?direction=x&quantity=index&input=P3` and `#/sweeps/{id}?baseline=STUDY&shown=difference`; anything else is the home view. */
export function parseRoute(hash: string): Route {
  const [path = "", query = ""] = hash.replace(/^#/, "").split("?", 2);
  const values = new URLSearchParams(query);
  const [, kind, id] = /^\/(studies|sweeps)\/([^/]+)$/.exec(path) ?? [];
  if (id === undefined) return { view: "home", preset: values.get("preset") };
  if (kind === "sweeps") {
    const shown = values.get("shown") === "difference" ? "difference" : "index";
    return { view: "sweep", id: decode(id), baseline: values.get("baseline"), shown };
  }
  const quantity = QUANTITIES.find((name) => name === values.get("quantity")) ?? "index";
  const direction = values.get("direction") === "y" ? "y" : "x";
  return { view: "study", id: decode(id), direction, quantity, input: values.get("input") };
}

/** The address of a view; what is at its default is left out. */
export function formatRoute(route: Route): string {
  const values = new URLSearchParams();
  if (route.view === "home") {
    if (route.preset !== null) values.set("preset", route.preset);
    return withQuery("#/", values);
  }
  if (route.view === "sweep") {
    if (route.baseline !== null) values.set("baseline", route.baseline);
    if (route.shown !== "index") values.set("shown", route.shown);
    return withQuery(`#/sweeps/${encodeURIComponent(route.id)}`, values);
  }
  values.set("direction", route.direction);
  if (route.quantity !== "index") values.set("quantity", route.quantity);
  if (route.input !== null) values.set("input", route.input);
  return withQuery(`#/studies/${encodeURIComponent(route.id)}`, values);
}

/** The view of a study before its reader chose anything. */
export function studyRoute(id: string): StudyRoute {
  return { view: "study", id, direction: "x", quantity: "index", input: null };
}

/** The view of a sweep before its reader chose anything. */
export function sweepRoute(id: string): SweepRoute {
  return { view: "sweep", id, baseline: null, shown: "index" };
}

function withQuery(path: string, values: URLSearchParams): string {
  const query = values.toString();
  return query === "" ? path : `${path}?${query}`;
}

function decode(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
