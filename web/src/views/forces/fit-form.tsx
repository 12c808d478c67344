import { bytes, integer } from "../../lib/format.ts";
import { columnWords, glance } from "../../lib/forces/recording-files.ts";
import type { ForcesDraftActions } from "../../state/forces/forces-draft.ts";
import type { ForcesDraft } from "../../state/app-state.ts";
import { Faults } from "../home/fault-list.tsx";
import { FileDrop } from "./file-drop.tsx";
import { LookPanel } from "./look-panel.tsx";

/** Recordings to learn from, and how: dropped, named, sent. */
export function FitForm({ draft, actions }: { draft: ForcesDraft; actions: ForcesDraftActions }) {
  const { files, sending, problem, look } = draft;
  const submit = (event: Event): void => {
    event.preventDefault();
    void actions.submit();
  };
  return (
    <section class="panel" aria-labelledby="fit-title">
      <h2 id="fit-title">Learn forces from recordings</h2>
      <form class="fit-form" onSubmit={submit}>
        <p>
          A recording is a CSV file of one run: a header, then in each row the time in seconds, the signals, and the forces where they were measured. Forces are
          columns like <code>fx_n</code>, <code>fy_n</code>, <code>fz_n</code>; all other columns are signals. Of two runs or more, each is estimated by models
          that learnt from the others alone.
        </p>
        <FileDrop title="Drop CSV files here, one for each run" isMany onFiles={(chosen) => void actions.add(chosen)} />
        <FileList files={files} onLeaveOut={actions.leaveOut} />
        <label for="fit-name">Name, the first file's when empty</label>
        <input
          id="fit-name"
          class="line"
          autocomplete="off"
          maxLength={200}
          value={draft.name}
          onInput={(event) => actions.edit({ name: event.currentTarget.value })}
        />
        <details open={draft.recipe !== ""}>
          <summary>Recipe: columns, preprocessing, features, models, validation</summary>
          <label for="recipe">TOML or JSON; what is left out has its default</label>
          <textarea
            id="recipe"
            spellcheck={false}
            autocomplete="off"
            rows={8}
            placeholder={'[columns]\nforces = "fz_n"\n\n[models]\nkinds = ["ridge", "gpr"]'}
            value={draft.recipe}
            aria-describedby="fit-faults"
            aria-invalid={problem !== null}
            onInput={(event) => actions.edit({ recipe: event.currentTarget.value })}
          />
        </details>
        <div id="fit-faults" aria-live="polite">
          {problem !== null && <Faults problem={problem} placeOf={() => null} idle="" />}
        </div>
        <div class="actions">
          <button type="submit" class="primary" disabled={sending || files.length === 0}>
            {sending ? "Sending …" : files.length < 2 ? "Learn forces" : `Learn forces from ${files.length} runs`}
          </button>
          <button type="button" disabled={files.length === 0 || look?.status === "loading"} onClick={() => void actions.look()}>
            Look at the columns
          </button>
          {files.length === 1 && <p class="quiet">With one run, cycles are left out, and nothing is said of other runs.</p>}
        </div>
      </form>
      <div aria-live="polite">{look !== null && <LookPanel look={look} />}</div>
    </section>
  );
}

function FileList({ files, onLeaveOut }: { files: ForcesDraft["files"]; onLeaveOut: (file: string) => void }) {
  if (files.length === 0) return <p class="quiet">No recording yet.</p>;
  return (
    <ul class="file-list" aria-label="Recordings">
      {files.map((recording) => {
        const { columns, rows } = glance(recording);
        return (
          <li key={recording.file}>
            <span>
              {recording.file}
              <span class="quiet">
                {integer(rows)} rows, {bytes(recording.text.length)}; {columnWords(columns)}
              </span>
            </span>
            <button type="button" class="plain" aria-label={`Leave ${recording.file} out`} title="Leave it out" onClick={() => onLeaveOut(recording.file)}>
              ×
            </button>
          </li>
        );
      })}
    </ul>
  );
}
