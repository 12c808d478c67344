import { useMemo, useRef } from "preact/hooks";
import { resolved, valueAt, withValue, type SceneOfName } from "../../lib/document/document-values.ts";
import { parseDraft, textOf } from "../../lib/document/draft-text.ts";
import { locate, tomlKey } from "../../lib/document/json-pointer.ts";
import type { Problem } from "../../api.ts";
import type { Actions } from "../../state/actions.ts";
import type { AppState, DraftCheck, FormTab, StudyDraft } from "../../state/app-state.ts";
import type { Fault } from "../../wire.ts";
import { later } from "../shared/later.tsx";
import { Loaded } from "../shared/loaded.tsx";
import { RadioChoice, type Option } from "../shared/radio-choice.tsx";
import { DocumentText } from "./document-text.tsx";
import { Faults, selectIn, type Place } from "./fault-list.tsx";
import { LayoutsForm } from "./form/layouts-form.tsx";
import { SceneForm } from "./form/scene-form.tsx";
import { PreviewPanel } from "./live/preview-panel.tsx";
import { RunBox } from "./live/run-box.tsx";
import { TireDrawing } from "./live/tire-drawing-figure.tsx";
import { NameField } from "./name-field.tsx";
import { PresetChoice } from "./preset-choice.tsx";
import { SweepForm } from "./sweep-form.tsx";
import { useNarrow } from "./use-narrow.ts";

const TABS: readonly Option<FormTab>[] = [
  { value: "form", label: "Form" },
  { value: "text", label: "JSON" },
  { value: "toml", label: "TOML" },
];

const TomlDocument = later("TOML", async () => (await import("./toml-document.tsx")).TomlDocument);

/** Picks a preset, edits its document by fields or as text, shows what it would give, and submits it or a sweep of it. In one column what it would give comes before the fields. */
export function StudyForm({ state, actions }: { state: AppState; actions: Actions }) {
  const { studyDraft: draft, draftCheck: check, presets } = state;
  const text = useRef<HTMLTextAreaElement>(null);
  const isNarrow = useNarrow();
  const scenes = presets.status === "ready" ? presets.value.scenes : [];
  const written = useMemo(() => readWritten(draft.text, scenes), [draft.text, scenes]);
  const problem = problemOf(draft, check);
  const placeOf = (pointer: string): Place | null => {
    const span = locate(draft.text, pointer);
    return span === null || draft.tab !== "text" ? null : { span, show: () => selectIn(text.current, span) };
  };
  // Nothing is drawn yet that the document would push away when it comes.
  if (draft.text === "" && draft.origin === null && presets.status === "loading") {
    return (
      <>
        <h1>New study</h1>
        <p class="quiet" role="status">
          Loading the presets …
        </p>
      </>
    );
  }
  const submit = (event: Event): void => {
    event.preventDefault();
    void actions.studyDraft.submit();
  };
  const faults = (
    <div key="faults" id="document-faults" aria-live="polite">
      {problem !== null && <Faults problem={problem} placeOf={placeOf} idle="" {...(draft.tab === "toml" ? { keyOf: tomlKey } : {})} />}
    </div>
  );
  const drawing = written !== null && (
    <section key="drawing" class="panel" aria-label="Drawing">
      <TireDrawing full={written.full} />
    </section>
  );
  const live = (
    <div key="live" class="new-study-live">
      <RunBox draft={draft} check={check} onAccuracy={actions.studyDraft.setAccuracy} />
      {!isNarrow && [faults, drawing]}
      <PreviewPanel preview={state.preview} text={draft.text} scene={written === null ? null : valueAt(written.full, "/scene")} />
    </div>
  );
  const document = (
    <section key="document" class="panel" aria-label="Document">
      {written !== null && (
        <NameField
          document={written.document}
          origin={draft.origin}
          scenes={scenes}
          onName={(name) => actions.studyDraft.edit(textOf(withValue(written.document, "/name", name)))}
        />
      )}
      <RadioChoice name="tab" legend="Write it as" options={TABS} chosen={draft.tab} onChoose={actions.studyDraft.showTab} />
      {draft.tab === "text" && <DocumentText language="JSON" value={draft.text} area={text} isWrong={problem !== null} onEdit={actions.studyDraft.edit} />}
      {draft.tab === "toml" && <TomlDocument draft={draft} area={text} isWrong={problem !== null} onEdit={actions.studyDraft.editToml} />}
      {draft.tab === "form" && <Fields written={written} faults={problem?.errors ?? NONE} onEdit={actions.studyDraft.edit} />}
    </section>
  );
  return (
    <>
      <h1>New study</h1>
      <form class="new-study" onSubmit={submit}>
        <section class="panel" aria-label="Start">
          <Loaded of={presets} what="the presets" onRetry={() => void actions.studyDraft.reloadPresets()}>
            {(value) => <PresetChoice presets={value.studies} chosen={draft.preset} onChoose={actions.studyDraft.choosePreset} />}
          </Loaded>
        </section>
        {isNarrow ? [live, document, faults, drawing] : [document, live]}
      </form>
      <SweepForm draft={state.sweepDraft} text={draft.text} placeInStudy={placeOf} actions={actions} />
    </>
  );
}

/** What is wrong with the draft: with what was typed as TOML, with its submission, or as its check says. */
function problemOf(draft: StudyDraft, check: DraftCheck): Problem | null {
  const fault = draft.toml?.of === draft.text ? draft.toml.fault : null;
  if (fault !== null) return { title: "The document can't be read.", status: 0, detail: fault.detail };
  return draft.problem ?? (check.text === draft.text ? check.problem : null);
}

const NONE: readonly Fault[] = [];

interface Written {
  /** What the form writes into: the document, a scene that is only named laid open. */
  document: unknown;
  full: unknown;
}

/** The document of a text; null while it is none. */
function readWritten(text: string, scenes: readonly SceneOfName[]): Written | null {
  const parsed = parseDraft(text);
  if ("fault" in parsed) return null;
  const full = resolved(parsed.document, scenes);
  return { document: typeof valueAt(parsed.document, "/scene") === "string" ? full : parsed.document, full };
}

function Fields({ written, faults, onEdit }: { written: Written | null; faults: readonly Fault[]; onEdit: (text: string) => void }) {
  if (written === null) return <p class="notice">The text can't be read, so there are no fields to show. Mend it under JSON or TOML.</p>;
  const { document, full } = written;
  if (typeof valueAt(full, "/scene") !== "object") return <p class="notice">The document has no scene that the form knows. Edit it under JSON or TOML.</p>;
  const replace = (next: unknown): void => onEdit(textOf(next));
  const props = { document, full, faults, replace, write: (pointer: string, value: unknown) => replace(withValue(document, pointer, value)) };
  return (
    <div>
      <SceneForm {...props} />
      <LayoutsForm {...props} />
    </div>
  );
}
