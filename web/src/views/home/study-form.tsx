import { useRef } from "preact/hooks";
import { ACCURACIES, accuracyOf, parseDraft, type Accuracy } from "../../lib/document/draft-text.ts";
import { locate } from "../../lib/document/json-pointer.ts";
import type { Actions } from "../../state/actions.ts";
import type { StudyDraft, SweepDraft } from "../../state/app-state.ts";
import type { Loadable } from "../../state/loadable.ts";
import type { Preset, Presets } from "../../wire.ts";
import { Loaded } from "../shared/loaded.tsx";
import { Faults, selectIn, type Place } from "./fault-list.tsx";
import { SweepForm } from "./sweep-form.tsx";

interface Props {
  draft: StudyDraft;
  sweep: SweepDraft;
  presets: Loadable<Presets>;
  actions: Actions;
}

const IDLE =
  "The document is checked when it is sent. Every fault is listed here with its place, and nothing runs until there is none.";

/** Picks a preset, edits its document, submits it or a sweep of it, and shows what is wrong with it. */
export function StudyForm({ draft, sweep, presets, actions }: Props) {
  const text = useRef<HTMLTextAreaElement>(null);
  const placeOf = (pointer: string): Place | null => {
    const span = locate(draft.text, pointer);
    return span === null ? null : { span, show: () => selectIn(text.current, span) };
  };
  const submit = (event: Event): void => {
    event.preventDefault();
    void actions.studyDraft.submit();
  };
  return (
    <>
      <section class="panel">
        <h1>New study</h1>
        <form class="new-study" onSubmit={submit}>
          <Loaded of={presets} what="the presets" onRetry={() => void actions.studyDraft.reloadPresets()}>
            {(value) => <PresetChoice presets={value.studies} chosen={draft.preset} onChoose={actions.studyDraft.choosePreset} />}
          </Loaded>
          <div class="document">
            <div class="document-text">
              <div class="document-head">
                <label for="document">Study document (JSON)</label>
                <AccuracyChoice text={draft.text} onChoose={actions.studyDraft.setAccuracy} />
              </div>
              <textarea
                id="document"
                ref={text}
                spellcheck={false}
                autocomplete="off"
                rows={24}
                value={draft.text}
                aria-describedby="document-faults"
                aria-invalid={draft.problem !== null}
                onInput={(event) => actions.studyDraft.edit(event.currentTarget.value)}
              />
            </div>
            <div id="document-faults" class="faults" aria-live="polite">
              <Faults problem={draft.problem} placeOf={placeOf} idle={IDLE} />
            </div>
          </div>
          <div class="actions">
            <button type="submit" class="primary" disabled={draft.sending || draft.text.trim() === ""}>
              {draft.sending ? "Sending …" : "Run study"}
            </button>
            <p class="quiet">Solved points are stored at once and reused: a study like an earlier one costs less.</p>
          </div>
        </form>
      </section>
      <SweepForm draft={sweep} text={draft.text} placeInStudy={placeOf} actions={actions} />
    </>
  );
}

function PresetChoice(props: { presets: Preset[]; chosen: string | null; onChoose: (name: string) => void }) {
  if (props.presets.length === 0) return <p class="quiet">The service ships no presets. Write a document below.</p>;
  return (
    <fieldset class="presets">
      <legend>Start from</legend>
      {props.presets.map((preset) => (
        <label key={preset.name} class="preset">
          <input
            type="radio"
            name="preset"
            value={preset.name}
            checked={preset.name === props.chosen}
            onChange={() => props.onChoose(preset.name)}
          />
          <span>
            <strong>{preset.title}</strong>
            <code>{preset.name}</code>
            <span class="quiet">{preset.comment}</span>
          </span>
        </label>
      ))}
    </fieldset>
  );
}

function AccuracyChoice({ text, onChoose }: { text: string; onChoose: (accuracy: Accuracy) => void }) {
  const readable = !("fault" in parseDraft(text));
  const accuracy = accuracyOf(text);
  return (
    <label class="inline">
      Accuracy{" "}
      <select
        value={accuracy ?? ""}
        disabled={!readable}
        onChange={(event) => onChoose(event.currentTarget.value as Accuracy)}
      >
        {accuracy === null && (
          <option value="" disabled>
            as written
          </option>
        )}
        {ACCURACIES.map((name) => (
          <option key={name} value={name}>
            {name}
          </option>
        ))}
      </select>
    </label>
  );
}
