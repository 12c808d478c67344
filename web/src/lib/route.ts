/** The view in the address bar: what a link shows is what its sender saw. */

import type { Direction } from "../types.ts";

/** What the map of the inner surface shows. */
export type Quantity = "index" | "std" | "strain" | "error";

export const QUANTITIES: readonly Quantity[] = ["index", "std", "strain", "error"];

export type Route =
  | { view: "home"; preset: string | null }
  | { view: "study"; id: string; direction: Direction; quantity: Quantity; input: string | null };

/** Reads `#/studies/{id}?direction=x&quantity=index&input=P3`; anything else is the home view. */
export function parseRoute(hash: string): Route {
  const [path = "", query = ""] = hash.replace(/^#/, "").split("?", 2);
  const values = new URLSearchParams(query);
  const id = /^\/studies\/([^/]+)$/.exec(path)?.[1];
  if (id === undefined) return { view: "home", preset: values.get("preset") };
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
  values.set("direction", route.direction);
  if (route.quantity !== "index") values.set("quantity", route.quantity);
  if (route.input !== null) values.set("input", route.input);
  return withQuery(`#/studies/${encodeURIComponent(route.id)}`, values);
}

/** The view of a study before its reader chose anything. */
export function studyRoute(id: string): Route {
  return { view: "study", id, direction: "x", quantity: "index", input: null };
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
