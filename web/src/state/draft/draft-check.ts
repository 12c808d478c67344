/** Checks the draft and asks what it would take, shortly after the last edit. */

import * as api from "../../api.ts";
import { parseDraft } from "../../lib/document/draft-text.ts";
import type { DraftCheck } from "../app-state.ts";
import { answerTo } from "../loadable.ts";
import { partOf, type Store } from "../store.ts";

/** Long enough that a word is typed in one go. */
const PAUSE_MS = 300;

interface DraftCheckActions {
  /** The draft may have changed. */
  look(): void;
}

export function createDraftCheck(store: Store): DraftCheckActions {
  const check = partOf(store, "draftCheck");
  const set = (change: Partial<DraftCheck>): void => check.set({ ...check.get(), ...change });
  let timer: number | null = null;
  let asked: AbortController | null = null;

  function look(): void {
    const { text } = store.get().studyDraft;
    if (text === "" || text === check.get().text) return;
    if (timer !== null) window.clearTimeout(timer);
    asked?.abort();
    const parsed = parseDraft(text);
    if ("fault" in parsed) {
      set({ text, asking: false, estimate: null, problem: { title: "The document can't be read.", status: 0, detail: parsed.fault.detail } });
      return;
    }
    // What was known stays in view until the answer comes.
    set({ text, asking: true });
    timer = window.setTimeout(() => void ask(parsed.document), PAUSE_MS);
  }

  async function ask(document: unknown): Promise<void> {
    const mine = new AbortController();
    asked = mine;
    const answer = await answerTo(api.estimate(document, mine.signal));
    if (mine.signal.aborted) return;
    if (answer.status === "ready") set({ asking: false, estimate: answer.value, problem: null });
    else set({ asking: false, estimate: null, problem: answer.problem });
  }

  return { look };
}
