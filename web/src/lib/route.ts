import type { Direction } from "./direction.ts";
import type { Edits } from "./document/draft-edits.ts";
import { PLAIN_SIGHT, readSight, writeSight, type Sight } from "./tire/view-address.ts";

/** The view in the address bar: what a link shows is what its sender saw. */

/** What the map of the inner surface shows. */
export type Quantity = "index" | "total" | "std" | "strain" | "error" | "signal";

export const QUANTITIES: readonly Quantity[] = ["index", "total", "std", "strain", "error", "signal"];

/** What the charts of a sweep show: the indices, or how they differ from the baseline's. */
export type Shown = "index" | "difference";

/** The form of a new study: of a preset, or of a study that is to be run again with changes, such as a layout with these films; and what its reader changed. */
export type HomeRoute = { view: "home"; preset: string | null; again: string | null; films: string | null; edits: Edits };
/** The layer of the inner surface that is shown. */
interface LayerChoice {
  direction: Direction;
  quantity: Quantity;
  /** Null for the centre's own. */
  input: string | null;
}
/** Whether compared layers are drawn unrolled or on the tires. */
export type DrawnAs = "maps" | "tires";
/** Studies side by side; the baseline is the first of them when none is named. */
export type CompareRoute = { view: "compare"; studies: string[]; baseline: string | null; shown: Shown; drawnAs: DrawnAs; sight: Sight } & LayerChoice;
/** What the cells of a grid of two fields show. */
export const CELL_FIGURES = ["answer", "index-x", "index-y", "angle-error"] as const;
export type CellFigure = (typeof CELL_FIGURES)[number];
/** `from` is the place of the first design that the table shows. */
export type SweepRoute = { view: "sweep"; id: string; from: number; baseline: string | null; shown: Shown; figure: CellFigure };

/** A study's pages, in the order of their links. */
export const SECTIONS = ["answer", "tire", "layouts", "indices", "trade", "run"] as const;
/** The sheet to glue by has no link among them: the answer and its files lead there. */
export type Section = (typeof SECTIONS)[number] | "sheet";

export type StudyRoute = { view: "study"; id: string; section: Section; films: string | null; sight: Sight } & LayerChoice;
/** All estimators of forces, and the form of a new one. */
type ForcesRoute = { view: "forces" };
/** Indices of a model of the reader's own. */
type OwnRoute = { view: "own" };
/** One estimator, with the force that its table and plot are of; its first when none is named. */
export type EstimatorRoute = { view: "estimator"; id: string; force: string | null };
/** An address that names no page. */
type NowhereRoute = { view: "nowhere"; address: string };
export type Route = HomeRoute | SweepRoute | StudyRoute | CompareRoute | ForcesRoute | OwnRoute | EstimatorRoute | NowhereRoute;

/** Reads `#/studies/{id}/tire?direction=x&quantity=index&input=P3`, `#/sweeps/{id}?baseline=STUDY&shown=difference`, `#/forces/{id}?force=fz_n` and `#/?preset=foot-tire&/scene/geometry/wall_mm=4`; without a path it is the home view. */
export function parseRoute(hash: string): Route {
  const [path = "", query = ""] = hash.replace(/^#/, "").split("?", 2);
  const values = new URLSearchParams(query);
  const shown = values.get("shown") === "difference" ? "difference" : "index";
  if (path === "/compare") {
    const studies = (values.get("studies") ?? "").split(",").filter((id) => id !== "");
    const drawnAs = values.get("as") === "tires" ? "tires" : "maps";
    return { view: "compare", studies, baseline: values.get("baseline"), shown, drawnAs, sight: readSight(values), ...layerIn(values) };
  }
  if (path === "/forces") return { view: "forces" };
  if (path === "/model") return { view: "own" };
  const estimator = /^\/forces\/([^/]+)$/.exec(path)?.[1];
  if (estimator !== undefined) return { view: "estimator", id: decode(estimator), force: values.get("force") };
  if (path === "" || path === "/") {
    const edits = Object.fromEntries([...values].filter(([pointer]) => pointer.startsWith("/")));
    return { view: "home", preset: values.get("preset"), again: values.get("again"), films: values.get("films"), edits };
  }
  const [, kind, id, section] = /^\/(studies|sweeps)\/([^/]+)(?:\/([^/]*))?$/.exec(path) ?? [];
  if (id === undefined) return { view: "nowhere", address: hash };
  const figure = CELL_FIGURES.find((name) => name === values.get("figure")) ?? "answer";
  if (kind === "sweeps") return { view: "sweep", id: decode(id), from: placeIn(values), baseline: values.get("baseline"), shown, figure };
  return { view: "study", id: decode(id), section: sectionOf(section, values), films: values.get("films"), sight: readSight(values), ...layerIn(values) };
}

/** A place counted from zero; the first one where it is none. */
function placeIn(values: URLSearchParams): number {
  const from = Number(values.get("from"));
  return Number.isSafeInteger(from) && from > 0 ? from : 0;
}

function layerIn(values: URLSearchParams): LayerChoice {
  const quantity = QUANTITIES.find((name) => name === values.get("quantity")) ?? "index";
  return { direction: values.get("direction") === "y" ? "y" : "x", quantity, input: values.get("input") };
}

function writeLayer({ direction, quantity, input }: LayerChoice, values: URLSearchParams): void {
  if (direction !== "x") values.set("direction", direction);
  if (quantity !== "index") values.set("quantity", quantity);
  if (input !== null) values.set("input", input);
}

/** Of links from before the sections: those that choose what the map shows open the map. */
function sectionOf(name: string | undefined, values: URLSearchParams): Section {
  const named = name === "sheet" ? name : SECTIONS.find((section) => section === name);
  if (named !== undefined) return named;
  return values.has("quantity") || values.has("input") ? "tire" : "answer";
}

/** The address of a view; what is at its default is left out. */
export function formatRoute(route: Route): string {
  const values = new URLSearchParams();
  if (route.view === "home") {
    if (route.preset !== null) values.set("preset", route.preset);
    if (route.again !== null) values.set("again", route.again);
    if (route.films !== null) values.set("films", route.films);
    for (const [pointer, value] of Object.entries(route.edits)) values.set(pointer, value);
    return withQuery("#/", values).replaceAll("%2F", "/").replaceAll("%2C", ",");
  }
  if (route.view === "forces") return "#/forces";
  if (route.view === "own") return "#/model";
  if (route.view === "nowhere") return route.address;
  if (route.view === "estimator") {
    if (route.force !== null) values.set("force", route.force);
    return withQuery(`#/forces/${encodeURIComponent(route.id)}`, values);
  }
  if (route.view === "sweep" || route.view === "compare") {
    if (route.view === "compare") values.set("studies", route.studies.join(","));
    if (route.baseline !== null) values.set("baseline", route.baseline);
    if (route.shown !== "index") values.set("shown", route.shown);
    if (route.view === "sweep" && route.figure !== "answer") values.set("figure", route.figure);
    if (route.view === "sweep" && route.from > 0) values.set("from", String(route.from));
    if (route.view === "sweep") return withQuery(`#/sweeps/${encodeURIComponent(route.id)}`, values);
    if (route.drawnAs !== "maps") values.set("as", route.drawnAs);
    writeLayer(route, values);
    writeSight(route.sight, values);
    return withQuery("#/compare", values);
  }
  const study = `#/studies/${encodeURIComponent(route.id)}`;
  writeLayer(route, values);
  writeSight(route.sight, values);
  if (route.films !== null) values.set("films", route.films);
  return withQuery(route.section === "answer" ? study : `${study}/${route.section}`, values);
}

const FIRST_LAYER: LayerChoice = { direction: "x", quantity: "index", input: null };

/** The form before its reader chose anything. */
export function homeRoute(): HomeRoute {
  return { view: "home", preset: null, again: null, films: null, edits: {} };
}

/** The form with the document of a study, and a layout of these films in it. */
export function againRoute(id: string, films: string | null = null): HomeRoute {
  return { ...homeRoute(), again: id, films };
}

/** The view of a study before its reader chose anything. */
export function studyRoute(id: string): StudyRoute {
  return { view: "study", id, section: "answer", films: null, sight: PLAIN_SIGHT, ...FIRST_LAYER };
}

/** Studies side by side before their reader chose anything. */
export function compareRoute(studies: string[]): CompareRoute {
  return { view: "compare", studies, baseline: null, shown: "index", drawnAs: "maps", sight: PLAIN_SIGHT, ...FIRST_LAYER };
}

/** The view of a sweep before its reader chose anything. */
export function sweepRoute(id: string): SweepRoute {
  return { view: "sweep", id, from: 0, baseline: null, shown: "index", figure: "answer" };
}

/** The view of an estimator before its reader chose a force. */
export function estimatorRoute(id: string): EstimatorRoute {
  return { view: "estimator", id, force: null };
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
