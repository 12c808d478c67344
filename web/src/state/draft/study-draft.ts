/** The study document being written: from a preset or an earlier study to its submission. */

import * as api from "../../api.ts";
import { named } from "../../lib/document/document-differences.ts";
import { parseDraft, textOf, withAccuracy, type Accuracy } from "../../lib/document/draft-text.ts";
import type { TypedToml } from "../../lib/document/toml/toml-text.ts";
import { filmsFrom, withFreeLayout } from "../../lib/layouts/moving/moved-films.ts";
import { studyRoute, type HomeRoute, type Route } from "../../lib/route.ts";
import { draftOf, newKey, type FormTab, type Origin, type StudyDraft } from "../app-state.ts";
import { answerTo } from "../loadable.ts";
import { partOf, type Store } from "../store.ts";

export interface StudyDraftActions {
  reloadPresets(): Promise<void>;
  choosePreset(name: string): void;
  /** The preset or the study of an address; the draft stays what it is while it was made from that. */
  showOrigin(route: HomeRoute): void;
  edit(text: string): void;
  /** The draft is what was typed as TOML. */
  editToml(toml: TypedToml): void;
  setAccuracy(accuracy: Accuracy): void;
  showTab(tab: FormTab): void;
  submit(): Promise<void>;
}

/** `onWritten` is told after every change of the text. */
export function createStudyDraft(store: Store, onSubmitted: (route: Route) => void, onWritten: () => void): StudyDraftActions {
  const [draft, presets] = [partOf(store, "studyDraft"), partOf(store, "presets")];
  const set = (change: Partial<StudyDraft>): void => draft.set({ ...draft.get(), ...change });

  function edit(text: string): void {
    set({ text, problem: null, idempotencyKey: newKey() });
    onWritten();
  }

  function editToml(toml: TypedToml): void {
    set({ toml });
    edit(toml.of);
  }

  function begin(origin: Origin, preset: string | null): void {
    draft.set(draftOf(origin, preset, draft.get().tab));
    onWritten();
  }

  async function reloadPresets(): Promise<void> {
    const answer = await answerTo(api.presets());
    presets.set(answer);
    const { route } = store.get();
    const isAgain = route.view === "home" && route.again !== null;
    if (answer.status !== "ready" || draft.get().text !== "" || isAgain) return;
    const wanted = route.view === "home" ? route.preset : null;
    const name = wanted ?? draft.get().preset ?? answer.value.studies[0]?.name;
    if (name !== undefined) choosePreset(name);
  }

  function choosePreset(name: string): void {
    const known = presets.get();
    const preset = known.status === "ready" ? known.value.studies.find((entry) => entry.name === name) : undefined;
    if (preset !== undefined) begin({ name: preset.title, document: preset.document, study: null, films: null }, preset.name);
  }

  function showOrigin({ preset, again, films }: HomeRoute): void {
    const { origin } = draft.get();
    if (again !== null && (again !== origin?.study || films !== origin.films)) return void loadStudy(again, films);
    if (again === null && preset !== null && preset !== draft.get().preset) choosePreset(preset);
  }

  async function loadStudy(id: string, films: string | null): Promise<void> {
    const answer = await answerTo(api.study(id));
    const { route } = store.get();
    if (route.view !== "home" || route.again !== id || route.films !== films) return;
    if (answer.status === "failed") return set({ problem: answer.problem });
    const { name, document } = answer.value;
    begin({ name, document, study: id, films }, null);
    const moved = filmsFrom(films);
    if (moved !== null) edit(textOf(withFreeLayout(document, moved)));
  }

  async function submit(): Promise<void> {
    const { text, toml, origin, idempotencyKey } = draft.get();
    const parsed = parseDraft(text);
    if ("fault" in parsed) {
      const fault = (toml?.of === text ? toml.fault : null) ?? parsed.fault;
      return set({ problem: { title: "The document can't be read.", status: 0, detail: fault.detail } });
    }
    const known = presets.get();
    const scenes = known.status === "ready" ? known.value.scenes : [];
    set({ sending: true, problem: null });
    const answer = await answerTo(api.submit(named(parsed.document, origin, scenes), idempotencyKey));
    if (answer.status === "failed") return set({ sending: false, problem: answer.problem });
    set({ sending: false, idempotencyKey: newKey() });
    onSubmitted(studyRoute(answer.value.id));
  }

  const setAccuracy = (accuracy: Accuracy): void => edit(withAccuracy(draft.get().text, accuracy));
  return { reloadPresets, choosePreset, showOrigin, edit, editToml, setAccuracy, showTab: (tab) => set({ tab }), submit };
}
