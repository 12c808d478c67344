import { useMemo } from "preact/hooks";
import { duration, microstrain, signed, significant } from "../../../lib/format.ts";
import { previewRows } from "../../../lib/document/preview/preview-rows.ts";
import type { StudyPreview } from "../../../state/app-state.ts";
import { ProblemText } from "../../shared/problem-box.tsx";
import { PreviewAnswer } from "./preview-answer.tsx";
import { PreviewBars } from "./preview-bars.tsx";
import { PreviewMaps } from "./preview-maps.tsx";
import type { Preview } from "../../../wire.ts";

/** What the draft would give, as far as the coarsest mesh tells; nothing where the service has no previews. */
export function PreviewPanel({ preview, text, scene }: { preview: StudyPreview; text: string; scene: unknown }) {
  if (preview.isOffered === false) return null;
  const { shown, start } = preview;
  const isStale = shown !== null && shown.text !== text;
  return (
    <section class="panel preview" aria-labelledby="preview-title" aria-busy={preview.asking}>
      <h2 id="preview-title">Preview</h2>
      <p class="preview-claim">Preview on a draft mesh, without a claim.</p>
      <Standing preview={preview} isStale={isStale} />
      {shown !== null && (
        <div class={isStale ? "preview-figures stale" : "preview-figures"}>
          <PreviewAnswer preview={shown.preview} scene={scene} />
          <Figures preview={shown.preview} start={start?.preview ?? null} />
        </div>
      )}
    </section>
  );
}

/** One line of its own height whatever it says, so that nothing below it jumps. */
function Standing({ preview, isStale }: { preview: StudyPreview; isStale: boolean }) {
  const { problem, shown, asking } = preview;
  if (asking && shown === null) return <p class="preview-standing">Solving the first preview …</p>;
  if (asking) return <p class="preview-standing">Solving …</p>;
  if (problem !== null && (problem.errors?.length ?? 0) > 0) return <p class="preview-standing">It waits until the faults are mended.</p>;
  if (problem?.status === 409) return <p class="preview-standing">Another page asked for a preview at the same time. The next edit asks again.</p>;
  if (problem !== null) {
    return (
      <div class="preview-standing">
        <ProblemText problem={problem} />
      </div>
    );
  }
  if (shown === null) return <p class="preview-standing">It waits for a document.</p>;
  const { solves, wall_s } = shown.preview;
  return <p class="preview-standing">{isStale ? "Of the document before the last edit." : `${solves} solves in ${duration(wall_s)}.`}</p>;
}

function Figures({ preview, start }: { preview: Preview; start: Preview | null }) {
  // The page's clock ticks every second, hundreds of cells needn't.
  return useMemo(() => {
    const rows = previewRows(preview, start);
    const { cut_point, map } = preview;
    const centre = cut_point.locations[Math.floor(cut_point.locations.length / 2)];
    const change = start === null || start === preview ? null : cut_point.reaction_n - start.cut_point.reaction_n;
    return (
      <>
        <p class="preview-force">
          Force <strong>{significant(cut_point.reaction_n)} N</strong>
          {change !== null && ` (${signed(change, 1)})`}
          {centre !== undefined && (
            <>
              {" · "}
              {centre.name} strain x <strong>{microstrain(centre.strain_x)}</strong>, y <strong>{microstrain(centre.strain_y)}</strong> µε
            </>
          )}
        </p>
        <PreviewBars rows={rows} isCompared={start !== null && start !== preview} />
        {map != null && <PreviewMaps map={map} />}
        {preview.notes.length > 0 && (
          <details>
            <summary>{preview.notes.length === 1 ? "One note" : `${preview.notes.length} notes`}</summary>
            <ul class="quiet">
              {preview.notes.map((note) => (
                <li key={note}>{note}</li>
              ))}
            </ul>
          </details>
        )}
      </>
    );
  }, [preview, start]);
}
