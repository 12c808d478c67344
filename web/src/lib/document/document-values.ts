/** Values of a study document by JSON pointer, and the scene that it means. Nothing is changed in place. */

import { pointerKeys } from "./json-pointer.ts";

export type Table = Record<string, unknown>;

/** A scene that the service ships. */
export interface SceneOfName {
  name: string;
  document: unknown;
}

export function isTable(value: unknown): value is Table {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** The value at a pointer; undefined where there is none. */
export function valueAt(document: unknown, pointer: string): unknown {
  return pointerKeys(pointer).reduce<unknown>((value, key) => {
    if (Array.isArray(value)) return (value as unknown[])[Number(key)];
    return isTable(value) && Object.hasOwn(value, key) ? value[key] : undefined;
  }, document);
}

/** The document with a value at a pointer; tables on the way that don't exist are made. Undefined takes the value away. */
export function withValue(document: unknown, pointer: string, value: unknown): unknown {
  return replaced(document, pointerKeys(pointer), value);
}

function replaced(node: unknown, [key, ...rest]: string[], value: unknown): unknown {
  if (key === undefined) return value;
  if (Array.isArray(node)) {
    const index = Number(key);
    if (rest.length === 0 && value === undefined) return node.filter((_, at) => at !== index);
    const copy: unknown[] = [...(node as unknown[])];
    copy[index] = replaced(copy[index], rest, value);
    return copy;
  }
  const table: Table = isTable(node) ? { ...node } : {};
  if (rest.length === 0 && value === undefined) delete table[key];
  else table[key] = replaced(table[key], rest, value);
  return table;
}

/** The document with its scene in full: a shipped scene that it names, its own tables laid over. As it is where the scene isn't known here. */
export function resolved(document: unknown, scenes: readonly SceneOfName[]): unknown {
  const scene = valueAt(document, "/scene");
  const name = typeof scene === "string" ? scene : isTable(scene) ? scene.preset : undefined;
  const base = scenes.find((known) => known.name === name)?.document;
  if (base === undefined) return document;
  if (!isTable(scene)) return withValue(document, "/scene", base);
  const { preset: _, ...overrides } = scene;
  return withValue(document, "/scene", laidOver(forgetful(base, overrides), overrides));
}

/** A shipped scene without what the tables laid over it exclude, as the service reads them: a force and depths, parameters of another law. */
function forgetful(base: unknown, overrides: Table): unknown {
  const has = (pointer: string): boolean => valueAt(overrides, pointer) !== undefined;
  const ground = [...(has("/ground/load_n") ? ["depths_mm", "stations"] : []), ...(has("/ground/depths_mm") ? ["load_n", "stations"] : [])];
  const scene = ground.reduce((left, field) => withValue(left, `/ground/${field}`, undefined), base);
  const isOtherLaw = has("/material/model") && valueAt(overrides, "/material/model") !== valueAt(base, "/material/model");
  return isOtherLaw ? withValue(scene, "/material", { d1_per_mpa: valueAt(base, "/material/d1_per_mpa") }) : scene;
}

function laidOver(base: unknown, over: unknown): unknown {
  if (!isTable(base) || !isTable(over)) return over;
  const merged: Table = { ...base };
  for (const [key, value] of Object.entries(over)) merged[key] = key in base ? laidOver(base[key], value) : value;
  return merged;
}

/** What an input calls the field at a pointer in the scene: `/scene/ground/depths_mm/0` -> `ground.depths_mm[0]`. */
export function pathOfPointer(pointer: string): string {
  return pointerKeys(pointer)
    .slice(1)
    .map((key, index) => (/^\d+$/.test(key) ? `[${key}]` : index === 0 ? key : `.${key}`))
    .join("");
}
