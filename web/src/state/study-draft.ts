/** The study document being written: from a preset to its submission. */

import * as api from "../api.ts";
import { parseDraft, withAccuracy, type Accuracy } from "../lib/document/draft-text.ts";
import { studyRoute, type Route } from "../lib/route.ts";
import { draftOf, newKey, type StudyDraft } from "./app-state.ts";
import { answerTo } from "./loadable.ts";
import { partOf, type Store } from "./store.ts";

export interface StudyDraftActions {
  reloadPresets(): Promise<void>;
  choosePreset(name: string): void;
  /** The preset of an address; it stays what it is while the document was made from it. */
  showPreset(name: string | null): void;
  edit(text: string): void;
  setAccuracy(accuracy: Accuracy): void;
  submit(): Promise<void>;
}

export function createStudyDraft(store: Store, onSubmitted: (route: Route) => void): StudyDraftActions {
  const [draft, presets] = [partOf(store, "studyDraft"), partOf(store, "presets")];
  const set = (change: Partial<StudyDraft>): void => draft.set({ ...draft.get(), ...change });
  const edit = (text: string): void => set({ text, problem: null, idempotencyKey: newKey() });

  async function reloadPresets(): Promise<void> {
    const answer = await answerTo(api.presets());
    presets.set(answer);
    if (answer.status !== "ready" || draft.get().text !== "") return;
    const { route } = store.get();
    const wanted = route.view === "home" ? route.preset : null;
    const name = wanted ?? draft.get().preset ?? answer.value.studies[0]?.name;
    if (name !== undefined) choosePreset(name);
  }

  function choosePreset(name: string): void {
    const known = presets.get();
    const preset = known.status === "ready" ? known.value.studies.find((entry) => entry.name === name) : undefined;
    if (preset !== undefined) draft.set(draftOf(preset.name, preset.document));
  }

  function showPreset(name: string | null): void {
    if (name !== null && name !== draft.get().preset) choosePreset(name);
  }

  async function submit(): Promise<void> {
    const { text, idempotencyKey } = draft.get();
    const parsed = parseDraft(text);
    if ("fault" in parsed) {
      return set({ problem: { title: "The document can't be read.", status: 0, detail: parsed.fault.detail } });
    }
    set({ sending: true, problem: null });
    const answer = await answerTo(api.submit(parsed.document, idempotencyKey));
    if (answer.status === "failed") return set({ sending: false, problem: answer.problem });
    set({ sending: false, idempotencyKey: newKey() });
    onSubmitted(studyRoute(answer.value.id));
  }

  const setAccuracy = (accuracy: Accuracy): void => edit(withAccuracy(draft.get().text, accuracy));
  return { reloadPresets, choosePreset, showPreset, edit, setAccuracy, submit };
}
