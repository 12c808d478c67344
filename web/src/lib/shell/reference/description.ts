/** The service's description of itself, as far as the page of its operations shows it. */

export interface Description {
  openapi: string;
  info: { title: string; version: string; description?: string };
  tags?: { name: string; description?: string }[];
  paths: Record<string, Record<string, DescribedOperation>>;
  components: { schemas: Record<string, Schema> };
}

export type Schema = Record<string, unknown>;

interface DescribedOperation {
  operationId?: string;
  tags?: string[];
  summary?: string;
  description?: string;
  parameters?: { name: string; in: string; description?: string; required?: boolean }[];
  requestBody?: { description?: string; content?: Record<string, Content> };
  responses?: Record<string, { description?: string; content?: Record<string, Content> }>;
}

export interface Content {
  schema?: Schema;
  example?: unknown;
}

/** One operation with its address. */
export interface Operation extends DescribedOperation {
  id: string;
  method: string;
  path: string;
}

const METHODS = ["get", "post", "patch", "put", "delete"];

/** Every operation, in the order of the tags, then of the description. */
export function operations({ paths, tags = [] }: Description): Operation[] {
  const all = Object.entries(paths).flatMap(([path, item]) =>
    METHODS.flatMap((method) => {
      const operation = item[method];
      if (operation === undefined) return [];
      return [{ ...operation, id: operation.operationId ?? `${method} ${path}`, method: method.toUpperCase(), path }];
    }),
  );
  const order = tags.map(({ name }) => name);
  const place = ({ tags: [tag = ""] = [] }: Operation): number => (order.indexOf(tag) + order.length + 1) % (order.length + 1);
  return [...all].sort((a, b) => place(a) - place(b));
}

/** Operations that have every word of the text somewhere: in method, address, summary, description or parameters. */
export function matching(all: Operation[], text: string): Operation[] {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  const whole = ({ method, path, summary, description, parameters }: Operation): string =>
    [method, path, summary, description, ...(parameters ?? []).map(({ name }) => name)].join(" ").toLowerCase();
  return all.filter((operation) => words.every((word) => whole(operation).includes(word)));
}

/** Name of the document that a body is, or whose list it is; none where it isn't one of the described documents. */
export function documentOf(content: Content): string | null {
  const { $ref, items } = (content.schema ?? {}) as { $ref?: unknown; items?: { $ref?: unknown } };
  const reference = $ref ?? items?.$ref;
  return typeof reference === "string" ? (reference.split("/").at(-1) ?? null) : null;
}

/** An example as text; none where there is no example. */
export function exampleText({ example }: Content): string | null {
  if (example === undefined || example === null) return null;
  return typeof example === "string" ? example : JSON.stringify(example, null, 2);
}

/** Five lines for a shell: from a document to its answer. */
export function firstLines(origin: string): string {
  const studies = `${origin}/v1/studies`;
  return [
    `curl -s ${origin}/v1/presets                                # what ships, to start from`,
    `curl -s -X POST -H 'content-type: application/toml' --data-binary @studies/foot-tire.toml ${studies}`,
    `curl -s ${studies}                                # states; the newest study first`,
    `curl -s ${studies}/$ID/result | jq .answer         # where the films go, and how sure that is`,
    `curl -s "${studies}/$ID/export?format=csv&table=locations" -o places.csv`,
  ].join("\n");
}
