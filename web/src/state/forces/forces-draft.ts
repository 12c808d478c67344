/** Recordings that forces are to be learnt from, and the recipe. */

import * as api from "../../api.ts";
import { recordingOf, withFiles } from "../../lib/forces/recording-files.ts";
import { estimatorRoute, type Route } from "../../lib/route.ts";
import { emptyForcesDraft, newKey, type ForcesDraft } from "../app-state.ts";
import { answerTo } from "../loadable.ts";
import { partOf, type Store } from "../store.ts";

export interface ForcesDraftActions {
  edit(change: Partial<Pick<ForcesDraft, "name" | "recipe">>): void;
  /** Reads files; one of the same name takes the place of the earlier. */
  add(files: readonly File[]): Promise<void>;
  leaveOut(file: string): void;
  /** Asks what the columns are taken for, before anything is learnt. */
  look(): Promise<void>;
  submit(): Promise<void>;
}

export function createForcesDraft(store: Store, onSubmitted: (route: Route) => void): ForcesDraftActions {
  const draft = partOf(store, "forcesDraft");
  const set = (change: Partial<ForcesDraft>): void => draft.set({ ...draft.get(), ...change });
  const changed = (change: Partial<ForcesDraft>): void => set({ ...change, problem: null, look: null, idempotencyKey: newKey() });

  async function add(files: readonly File[]): Promise<void> {
    const read = await answerTo(Promise.all(files.map(recordingOf)));
    if (read.status === "failed")
      return set({ problem: { title: "A file can't be read.", status: 0, detail: `A file can't be read. ${read.problem.detail ?? ""}` } });
    changed({ files: withFiles(draft.get().files, read.value) });
  }

  /** The recipe's document; null, and said, where there is none. */
  async function recipeOf(): Promise<{ document: unknown } | null> {
    const recipe = await readRecipe(draft.get().recipe);
    if (typeof recipe !== "string") return recipe;
    set({ problem: { title: "The recipe can't be read.", status: 0, detail: recipe } });
    return null;
  }

  async function look(): Promise<void> {
    const { files, idempotencyKey } = draft.get();
    const recipe = await recipeOf();
    if (recipe === null) return;
    set({ problem: null, look: { status: "loading" } });
    const answer = await answerTo(api.lookAt({ recipe: recipe.document, recordings: files }));
    // What was edited meanwhile was looked at as it was before.
    if (draft.get().idempotencyKey === idempotencyKey) set({ look: answer });
  }

  async function submit(): Promise<void> {
    const { name, files, idempotencyKey } = draft.get();
    const recipe = await recipeOf();
    if (recipe === null) return;
    set({ sending: true, problem: null });
    const document = { ...(name.trim() === "" ? {} : { name: name.trim() }), recipe: recipe.document, recordings: files };
    const answer = await answerTo(api.fitForces(document, idempotencyKey));
    if (answer.status === "failed") return set({ sending: false, problem: answer.problem });
    draft.set(emptyForcesDraft());
    onSubmitted(estimatorRoute(answer.value.id));
  }

  return { edit: changed, add, leaveOut: (file) => changed({ files: draft.get().files.filter((each) => each.file !== file) }), look, submit };
}

/** The document of TOML or JSON, or why there is none. Their reader is loaded by those who write a recipe alone. */
async function readRecipe(text: string): Promise<{ document: unknown } | string> {
  if (text.trim() === "") return { document: {} };
  const { readToml } = await import("../../lib/document/toml/toml-text.ts");
  const { of, fault } = readToml(text);
  return fault === null ? { document: JSON.parse(of) as unknown } : fault.detail;
}
