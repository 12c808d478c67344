/** Solves the draft on the coarsest mesh after every edit: one at a time, and of the edits meanwhile only the newest. */

import * as api from "../../api.ts";
import { parseDraft } from "../../lib/document/draft-text.ts";
import { createNewestWaits } from "../../lib/document/newest-waits.ts";
import type { Origin, StudyPreview } from "../app-state.ts";
import { answerTo } from "../loadable.ts";
import { partOf, type Store } from "../store.ts";

interface StudyPreviewActions {
  /** The draft may have changed. */
  look(): void;
}

interface Edit {
  text: string;
  document: unknown;
  origin: Origin | null;
}

/** What a service answers that has no previews. */
const NOT_OFFERED = [404, 405];

export function createStudyPreview(store: Store): StudyPreviewActions {
  const preview = partOf(store, "preview");
  const set = (change: Partial<StudyPreview>): void => preview.set({ ...preview.get(), ...change });
  const edits = createNewestWaits<Edit>(ask);
  let looked = "";

  function look(): void {
    const { text, origin } = store.get().studyDraft;
    if (preview.get().isOffered === false || text === "" || text === looked) return;
    looked = text;
    const parsed = parseDraft(text);
    if ("fault" in parsed) edits.drop();
    else edits.offer({ text, document: parsed.document, origin });
  }

  async function ask({ text, document, origin }: Edit): Promise<void> {
    set({ asking: true });
    const answer = await answerTo(api.preview(document));
    if (answer.status === "ready") {
      const { start } = preview.get();
      const first = start !== null && start.origin === origin ? start : { origin, preview: answer.value };
      return set({ isOffered: true, asking: false, shown: { text, preview: answer.value }, start: first, problem: null });
    }
    const { problem } = answer;
    set(NOT_OFFERED.includes(problem.status) ? { isOffered: false, asking: false } : { asking: false, problem });
  }

  return { look };
}
