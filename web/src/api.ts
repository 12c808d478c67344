/** The only file that talks to the network. */

import type { Page } from "./lib/shell/pages.ts";
import type { Description } from "./lib/shell/reference/description.ts";
import type { RecordingFile } from "./lib/forces/recording-files.ts";
import { EVENT_KINDS, type StudyEvent } from "./lib/study/stream-events.ts";
import type {
  Comparison,
  EngineList,
  EngineView,
  EntryChange,
  Estimate,
  EstimatorDetail,
  EstimatorPage,
  EstimatorSummary,
  FilmFields,
  FilmPlace,
  LeftOutRows,
  Look,
  ModelAnalysis,
  Presets,
  Preview,
  ProblemDocument,
  Report,
  ScoredLayouts,
  Sections,
  StudyDetail,
  StudyPage,
  StudyResult,
  StudySummary,
  SweepDetail,
  SweepEstimate,
  SweepPage,
  SweepSummary,
  Trade,
} from "./wire.ts";

/** Relative to the page, which a proxy may serve below a path. */
const ROOT = "v1";
/** The service counts the designs of the sweeps that it lists, and the list is asked for again and again. */
const SWEEPS_OF_A_PAGE = 10;

/** What the service says is wrong. The page has problems of its own, of which there is less to say. */
export type Problem = Pick<ProblemDocument, "title" | "status"> & Partial<ProblemDocument>;

/** An answer that is not the one asked for, or no answer at all. */
class ApiError extends Error {
  readonly problem: Problem;

  constructor(problem: Problem) {
    super(problem.title);
    this.problem = problem;
  }
}

/** The problem of anything thrown. */
export function problemOf(error: unknown): Problem {
  if (error instanceof ApiError) return error.problem;
  return { title: "The page failed.", status: 0, detail: error instanceof Error ? error.message : String(error) };
}

/** What the stream of one study calls. */
interface StreamListener {
  event(event: StudyEvent): void;
  /** The stream is open. */
  open(): void;
  /** The stream broke; it may come back. */
  lost(): void;
}

/** The service's description of itself. */
export function description(): Promise<Description> {
  return asked("GET", "openapi.json");
}

export function presets(): Promise<Presets> {
  return request("GET", "/presets");
}

/** What is looked for in the lists. */
export interface Wanted {
  /** A part of the name, or the beginning of the identifier; all when empty. */
  search: string;
  /** Archived ones alone; others alone otherwise. */
  archived: boolean;
}

/** Studies by themselves: the designs of a sweep are on its own page. */
export async function studies(wanted: Wanted, cursor: string | null): Promise<Page<StudySummary>> {
  const page = await request<StudyPage>("GET", `/studies?sweep=none${listed(wanted, cursor)}`);
  return { entries: page.studies, next_cursor: page.next_cursor ?? null };
}

export function study(id: string): Promise<StudyDetail> {
  return request("GET", path(id));
}

/** The result with its map, which is most of the document. A service that doesn't know the question always sends it. */
export function result(id: string, map: boolean): Promise<StudyResult> {
  return request("GET", path(id, map ? "/result" : "/result?map=false"));
}

export function trade(id: string): Promise<Trade> {
  return request("GET", path(id, "/trade"));
}

/** Both skins of the whole wheel, as `readSurface` reads them. */
export async function surface(id: string): Promise<ArrayBuffer> {
  return (await answer("GET", `${ROOT}${path(id, "/surface")}`)).arrayBuffer();
}

/** Strain and shape over the map at the solved values of an input. */
export function sections(id: string, input: string): Promise<Sections> {
  return request("GET", path(id, `/sections?input=${encodeURIComponent(input)}`));
}

/** What every kind of film reads around the wheel, as exactly as the service scores layouts by it. */
export function filmFields(id: string): Promise<FilmFields> {
  return request("GET", path(id, "/layouts/fields"));
}

/** The service's scores of a layout, simulated errors with them. */
export function scoreLayout(id: string, films: readonly FilmPlace[]): Promise<ScoredLayouts> {
  return request("POST", path(id, "/layouts:score"), { layouts: [{ films }], simulated: true });
}

/** Submits a document; the same key finds the same study again, so that a lost answer can be asked for twice. */
export function submit(document: unknown, idempotencyKey: string): Promise<{ id: string }> {
  return request("POST", "/studies", document, { "Idempotency-Key": idempotencyKey });
}

/** Checks a document, and asks what its study would take. */
export function estimate(document: unknown, signal: AbortSignal): Promise<Estimate> {
  return request("POST", "/studies:estimate", document, {}, signal);
}

/** Solves a document on the draft mesh at once; nothing of it is stored. */
export function preview(document: unknown): Promise<Preview> {
  return request("POST", "/studies:preview", document);
}

export function cancel(id: string): Promise<unknown> {
  return request("DELETE", path(id));
}

/** Removes a study for good. */
export function removeStudy(id: string): Promise<unknown> {
  return request("DELETE", path(id, "?purge"));
}

/** Renames or archives a study: what lists say of it alone. */
export function changeStudy(id: string, change: EntryChange): Promise<StudySummary> {
  return request("PATCH", path(id), change);
}

/** The same of a sweep. */
export function changeSweep(id: string, change: EntryChange): Promise<SweepSummary> {
  return request("PATCH", sweepPath(id), change);
}

export async function sweeps(wanted: Wanted, cursor: string | null): Promise<Page<SweepSummary>> {
  const page = await request<SweepPage>("GET", `/sweeps?limit=${SWEEPS_OF_A_PAGE}${listed(wanted, cursor)}`);
  return { entries: page.sweeps, next_cursor: page.next_cursor ?? null };
}

/** Designs that a sweep's page shows at once. */
export const DESIGNS_OF_A_PAGE = 1000;

/** A sweep with its designs from a place on. */
export function sweep(id: string, from: number): Promise<SweepDetail> {
  return request("GET", sweepPath(id, `?from=${from}&limit=${DESIGNS_OF_A_PAGE}`));
}

export function cancelSweep(id: string): Promise<SweepDetail> {
  return request("DELETE", sweepPath(id));
}

/** Removes a sweep for good, with its designs. */
export function removeSweep(id: string): Promise<unknown> {
  return request("DELETE", sweepPath(id, "?purge"));
}

export function resumeSweep(id: string): Promise<SweepDetail> {
  return request("POST", sweepPath(id, "/resume"));
}

/** The designs of a sweep beside the one of this study, or beside the first that has a result. */
export function comparison(sweep: string, baseline: string | null): Promise<Comparison> {
  return request("GET", comparisonPath(sweep, baseline));
}

/** Studies beside the first that has a result, or beside the baseline. */
export function studyComparison(studies: readonly string[], baseline: string | null): Promise<Comparison> {
  const values = new URLSearchParams({ studies: studies.join(",") });
  if (baseline !== null) values.set("baseline", baseline);
  return request("GET", `/comparison?${values.toString()}`);
}

export function estimateSweep(document: unknown): Promise<SweepEstimate> {
  return request("POST", "/sweeps:estimate", document);
}

/** Submits a sweep, to other machines where an engine is named; the same key finds the same sweep again. */
export function submitSweep(document: unknown, engine: string | null, idempotencyKey: string): Promise<{ id: string }> {
  const path = engine === null ? "/sweeps" : `/sweeps?engine=${encodeURIComponent(engine)}`;
  return request("POST", path, document, { "Idempotency-Key": idempotencyKey });
}

/** Engines by which other machines solve designs, with what they are at. */
export async function engines(): Promise<EngineView[]> {
  const list = await request<EngineList>("GET", "/engines");
  return list.engines;
}

/** Estimators of forces, newest first. */
export async function estimators(cursor: string | null): Promise<Page<EstimatorSummary>> {
  const page = await request<EstimatorPage>("GET", `/estimators${cursor === null ? "" : `?cursor=${encodeURIComponent(cursor)}`}`);
  return { entries: page.estimators, next_cursor: page.next_cursor ?? null };
}

export function estimator(id: string): Promise<EstimatorDetail> {
  return request("GET", estimatorPath(id));
}

/** What was found of each force. */
export function report(id: string): Promise<Report> {
  return request("GET", estimatorPath(id, "/report"));
}

/** Rows that weren't learnt from, as they were estimated: a list for each force. */
export async function leftOut(id: string): Promise<LeftOutRows[]> {
  return (await request<{ forces: LeftOutRows[] }>("GET", estimatorPath(id, "/left-out"))).forces;
}

/** Learns forces from recordings; the same key finds the same estimator again. */
export function fitForces(document: { name?: string; recipe: unknown; recordings: readonly RecordingFile[] }, idempotencyKey: string): Promise<{ id: string }> {
  return request("POST", "/estimators", document, { "Idempotency-Key": idempotencyKey });
}

/** What each column of recordings is taken for, and what stands in it. */
export function lookAt(document: { recipe: unknown; recordings: readonly RecordingFile[] }): Promise<Look> {
  return request("POST", "/recordings:look", document);
}

/** The forces of a recording as CSV. */
export async function applyEstimator(id: string, recording: RecordingFile): Promise<string> {
  return (await answer("POST", `${ROOT}${estimatorPath(id, ":apply")}`, recording, { Accept: "text/csv, application/problem+json" })).text();
}

/** The indices of a model of the reader's own, as far as a file of values tells them; the points to run at first. */
export function analyse(inputs: object, values: string | null): Promise<ModelAnalysis> {
  return request("POST", "/analyses", values === null ? inputs : { ...inputs, values });
}

export function cancelEstimator(id: string): Promise<unknown> {
  return request("DELETE", estimatorPath(id));
}

/** Removes an estimator for good, with its recordings. */
export function removeEstimator(id: string): Promise<unknown> {
  return request("DELETE", estimatorPath(id, "?purge"));
}

/** The address of a part of an estimator, for a link. */
export function estimatorAddress(id: string, part: "" | "/report" | "/model" | "/left-out"): string {
  return `${ROOT}${estimatorPath(id, part)}`;
}

/** The films of the answer as an SVG to glue by, 1:1 on paper. */
export async function template(id: string): Promise<string> {
  return (await answer("GET", address(id, "export?format=svg"), undefined, { Accept: "image/svg+xml, application/problem+json" })).text();
}

/** The address of a part of a study, for a link. */
export function address(id: string, part: "result" | "evaluations" | `export?${string}`): string {
  return `${ROOT}${path(id, `/${part}`)}`;
}

/** The address of a sweep, for a link. */
export function sweepAddress(id: string): string {
  return `${ROOT}${sweepPath(id)}`;
}

/** The address of its comparison. */
export function comparisonAddress(sweep: string, baseline: string | null): string {
  return `${ROOT}${comparisonPath(sweep, baseline)}`;
}

/** The address of a comparison of these studies, or of a sweep's designs, as a table to download. */
export function comparisonExport(of: { sweep: string } | { studies: string }, baseline: string | null, query: string): string {
  const rest = baseline === null ? query : `${query}&baseline=${encodeURIComponent(baseline)}`;
  return `${ROOT}/comparison/export?${new URLSearchParams({ ...of }).toString()}&${rest}`;
}

/** Listens to a study until the returned function is called. */
export function follow(id: string, listener: StreamListener): () => void {
  const source = new EventSource(`${ROOT}${path(id, "/events")}`);
  for (const kind of EVENT_KINDS) {
    source.addEventListener(kind, (message: MessageEvent<string>) => {
      listener.event({ ...(JSON.parse(message.data) as object), kind } as StudyEvent);
    });
  }
  source.addEventListener("open", () => listener.open());
  source.addEventListener("error", () => listener.lost());
  return () => source.close();
}

/** The rest of a list's query. */
function listed({ search, archived }: Wanted, cursor: string | null): string {
  const values = new URLSearchParams();
  if (search !== "") values.set("search", search);
  if (archived) values.set("archived", "true");
  if (cursor !== null) values.set("cursor", cursor);
  return values.size === 0 ? "" : `&${values.toString()}`;
}

function path(id: string, rest = ""): string {
  return `/studies/${encodeURIComponent(id)}${rest}`;
}

function sweepPath(id: string, rest = ""): string {
  return `/sweeps/${encodeURIComponent(id)}${rest}`;
}

function estimatorPath(id: string, rest = ""): string {
  return `/estimators/${encodeURIComponent(id)}${rest}`;
}

function comparisonPath(sweep: string, baseline: string | null): string {
  const values = new URLSearchParams({ sweep });
  if (baseline !== null) values.set("baseline", baseline);
  return `/comparison?${values.toString()}`;
}

function request<T>(method: string, where: string, body?: unknown, headers: HeadersInit = {}, signal: AbortSignal | null = null): Promise<T> {
  return asked(method, `${ROOT}${where}`, body, headers, signal);
}

async function asked<T>(method: string, where: string, body?: unknown, headers: HeadersInit = {}, signal: AbortSignal | null = null): Promise<T> {
  const response = await answer(method, where, body, headers, signal);
  const text = await response.text();
  try {
    return (text === "" ? null : JSON.parse(text)) as T;
  } catch {
    throw new ApiError({ title: "The service's answer is not JSON.", status: response.status });
  }
}

/** What the service answers, unless it refuses. */
async function answer(method: string, where: string, body?: unknown, headers: HeadersInit = {}, signal: AbortSignal | null = null): Promise<Response> {
  // What is removed is removed when the page is left, too.
  const options: RequestInit = { method, signal, keepalive: method === "DELETE", headers: { Accept: "application/json", ...headers } };
  if (body !== undefined) {
    options.body = JSON.stringify(body);
    options.headers = { ...options.headers, "Content-Type": "application/json" };
  }
  let response: Response;
  try {
    response = await fetch(where, options);
  } catch {
    throw new ApiError({ title: "The service doesn't answer. Is strainsite still running?", status: 0 });
  }
  if (!response.ok) throw new ApiError(await problemIn(response));
  return response;
}

async function problemIn(response: Response): Promise<Problem> {
  const fallback: Problem = { title: `The service answered ${response.status}.`, status: response.status };
  try {
    const body = (await response.json()) as Partial<Problem> | null;
    return { ...fallback, ...body };
  } catch {
    return fallback;
  }
}
