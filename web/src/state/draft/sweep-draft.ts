/** The sweep being written: its grid, what it would take, its submission. */

import * as api from "../../api.ts";
import { parseDraft } from "../../lib/document/draft-text.ts";
import { sweepRoute, type Route } from "../../lib/route.ts";
import { readGrid } from "../../lib/sweep/design-grid.ts";
import type { Fault } from "../../wire.ts";
import { newKey, type SweepDraft } from "../app-state.ts";
import { answerTo } from "../loadable.ts";
import { partOf, type Store } from "../store.ts";

export interface SweepDraftActions {
  edit(change: Partial<Pick<SweepDraft, "name" | "grid">>): void;
  /** Chooses whose machines solve it. */
  choose(engine: string | null): void;
  /** Checks what is written, and asks what it would take. */
  estimate(): Promise<void>;
  /** Submits what was estimated. */
  submit(): Promise<void>;
}

export function createSweepDraft(store: Store, onSubmitted: (route: Route) => void): SweepDraftActions {
  const draft = partOf(store, "sweepDraft");
  const set = (change: Partial<SweepDraft>): void => draft.set({ ...draft.get(), ...change });
  const edit: SweepDraftActions["edit"] = (change) => set({ ...change, problem: null, estimated: null });

  async function estimate(): Promise<void> {
    const { text } = store.get().studyDraft;
    const parsed = parseDraft(text);
    if ("fault" in parsed) return set(unreadable(parsed.fault.detail, []));
    const grid = readGrid(draft.get().grid);
    if (grid.faults.length > 0) return set(unreadable("The grid can't be read yet.", grid.faults));
    const name = draft.get().name.trim();
    const document = { ...(name === "" ? {} : { name }), study: parsed.document, grid: grid.document };
    set({ busy: "estimating", problem: null, estimated: null });
    const [answer, there] = await Promise.all([answerTo(api.estimateSweep(document)), answerTo(api.engines())]);
    if (answer.status === "failed") return set({ busy: null, problem: answer.problem });
    // Without its list of engines the service solves it all the same.
    const engines: string[] = there.status === "ready" ? there.value.map(({ name }) => name) : [];
    set({ busy: null, estimated: { estimate: answer.value, engines, text, document, idempotencyKey: newKey() } });
  }

  async function submit(): Promise<void> {
    const { estimated, engine } = draft.get();
    if (estimated === null) return;
    set({ busy: "sending", problem: null });
    const own = estimated.engines.includes(engine ?? "") ? engine : null;
    const answer = await answerTo(api.submitSweep(estimated.document, own, estimated.idempotencyKey));
    if (answer.status === "failed") return set({ busy: null, problem: answer.problem });
    set({ busy: null, estimated: null });
    onSubmitted(sweepRoute(answer.value.id));
  }

  return { edit, choose: (engine) => set({ engine }), estimate, submit };
}

function unreadable(detail: string, errors: Fault[]): Partial<SweepDraft> {
  return { estimated: null, problem: { title: "The sweep can't be read.", status: 0, detail, errors } };
}
