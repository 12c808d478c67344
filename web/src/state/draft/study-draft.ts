/** The study document being written: from a preset or an earlier study to its submission. */

import * as api from "../../api.ts";
import { named } from "../../lib/document/document-differences.ts";
import { edited, type Edits } from "../../lib/document/draft-edits.ts";
import { parseDraft, textOf, withAccuracy, type Accuracy } from "../../lib/document/draft-text.ts";
import type { TypedToml } from "../../lib/document/toml/toml-text.ts";
import { studyRoute, type HomeRoute, type Route } from "../../lib/route.ts";
import type { Presets } from "../../wire.ts";
import { draftOf, newKey, type FormTab, type Origin, type StudyDraft } from "../app-state.ts";
import { answerTo } from "../loadable.ts";
import { partOf, type Store } from "../store.ts";
import { baseOf, createDraftAddress } from "./draft-address.ts";

export interface StudyDraftActions {
  reloadPresets(): Promise<void>;
  choosePreset(name: string): void;
  /** The draft of an address; it stays what it is while the address is its own, or says nothing. */
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
  const address = createDraftAddress(store);
  const known = (): Presets => {
    const answer = presets.get();
    return answer.status === "ready" ? answer.value : { studies: [], scenes: [] };
  };

  function put(text: string): void {
    set({ text, problem: null, idempotencyKey: newKey() });
    onWritten();
  }

  function edit(text: string): void {
    put(text);
    address.write();
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
    presets.set(await answerTo(api.presets()));
    const { route } = store.get();
    if (route.view === "home" && route.again === null && draft.get().text === "") showOrigin(route);
  }

  function beginPreset(name: string): void {
    const preset = known().studies.find((entry) => entry.name === name);
    if (preset !== undefined) begin({ name: preset.title, document: preset.document, study: null, films: null }, preset.name);
  }

  function choosePreset(name: string): void {
    beginPreset(name);
    address.write();
  }

  function showOrigin(route: HomeRoute): void {
    const { text, origin } = draft.get();
    const { again, films, edits } = route;
    if (text !== "" && address.isOf(route)) address.settle();
    else if (again === null) showPreset(route.preset ?? known().studies[0]?.name, edits);
    else if (again === origin?.study && films === origin.films) show(edits);
    else void loadStudy(route, again);
  }

  function showPreset(name: string | undefined, edits: Edits): void {
    if (name === undefined) return;
    if (name !== draft.get().preset) beginPreset(name);
    // Not here yet, or none that the service ships.
    if (name === draft.get().preset) show(edits);
  }

  /** The document that the draft began with, with these edits. */
  function show(edits: Edits): void {
    const { origin, text } = draft.get();
    if (origin === null) return;
    const next = textOf(edited(baseOf(origin), edits));
    if (next !== text) put(next);
    address.settle();
  }

  async function loadStudy({ films, edits }: HomeRoute, id: string): Promise<void> {
    const answer = await answerTo(api.study(id));
    const { route } = store.get();
    if (route.view !== "home" || route.again !== id || route.films !== films) return;
    if (answer.status === "failed") return set({ problem: answer.problem });
    const { name, document } = answer.value;
    begin({ name, document, study: id, films }, null);
    show(edits);
  }

  async function submit(): Promise<void> {
    address.flush();
    const { text, toml, origin, idempotencyKey } = draft.get();
    const parsed = parseDraft(text);
    if ("fault" in parsed) {
      const fault = (toml?.of === text ? toml.fault : null) ?? parsed.fault;
      return set({ problem: { title: "The document can't be read.", status: 0, detail: fault.detail } });
    }
    set({ sending: true, problem: null });
    const answer = await answerTo(api.submit(named(parsed.document, origin, known().scenes), idempotencyKey));
    if (answer.status === "failed") return set({ sending: false, problem: answer.problem });
    set({ sending: false, idempotencyKey: newKey() });
    onSubmitted(studyRoute(answer.value.id));
  }

  const setAccuracy = (accuracy: Accuracy): void => edit(withAccuracy(draft.get().text, accuracy));
  return { reloadPresets, choosePreset, showOrigin, edit, editToml, setAccuracy, showTab: (tab) => set({ tab }), submit };
}
