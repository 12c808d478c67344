/** What the reader does with sweeps: writes one, follows it, cancels it, resumes it. */

import * as api from "../api.ts";
import { parseDraft } from "../lib/document/draft.ts";
import { readGrid } from "../lib/document/design-grid.ts";
import { sweepRoute, type Route } from "../lib/route.ts";
import { mergeSweeps, newKey, type Store, type SweepDraft } from "./app-state.ts";
import { createSweepFollower } from "./sweep-follower.ts";
import type { SweepDetail } from "../sweep-types.ts";
import type { Fault, Problem } from "../types.ts";

export interface SweepActions {
  editSweep(change: Partial<Pick<SweepDraft, "name" | "grid">>): void;
  /** Checks the sweep that is being written, and asks what it would take. */
  estimateSweep(): Promise<void>;
  /** Submits what was estimated. */
  submitSweep(): Promise<void>;
  reloadSweeps(): Promise<void>;
  loadOlderSweeps(): Promise<void>;
  openSweep(id: string): void;
  closeSweep(): void;
  reopenSweep(): void;
  cancelSweep(): Promise<void>;
  resumeSweep(): Promise<void>;
}

export function createSweepActions(store: Store, go: (route: Route) => void): SweepActions {
  const follower = createSweepFollower(store, () => void reloadSweeps());
  const setDraft = (change: Partial<SweepDraft>): void =>
    store.update((state) => ({ ...state, sweepDraft: { ...state.sweepDraft, ...change } }));

  const editSweep: SweepActions["editSweep"] = (change) => setDraft({ ...change, problem: null, estimated: null });

  async function estimateSweep(): Promise<void> {
    const { draft, sweepDraft } = store.get();
    const parsed = parseDraft(draft.text);
    const grid = readGrid(sweepDraft.grid);
    if ("fault" in parsed) return setDraft({ estimated: null, problem: unreadable(parsed.fault.detail, []) });
    if (grid.faults.length > 0) {
      return setDraft({ estimated: null, problem: unreadable("The grid can't be read yet.", grid.faults) });
    }
    const name = sweepDraft.name.trim();
    const document = { ...(name === "" ? {} : { name }), study: parsed.document, grid: grid.document };
    setDraft({ busy: "estimating", problem: null, estimated: null });
    try {
      const estimate = await api.estimateSweep(document);
      setDraft({ busy: null, estimated: { estimate, text: draft.text, document, idempotencyKey: newKey() } });
    } catch (error) {
      setDraft({ busy: null, problem: api.problemOf(error) });
    }
  }

  async function submitSweep(): Promise<void> {
    const { estimated } = store.get().sweepDraft;
    if (estimated === null) return;
    setDraft({ busy: "sending", problem: null });
    try {
      const { id } = await api.submitSweep(estimated.document, estimated.idempotencyKey);
      setDraft({ busy: null, estimated: null });
      void reloadSweeps();
      go(sweepRoute(id));
    } catch (error) {
      setDraft({ busy: null, problem: api.problemOf(error) });
    }
  }

  async function reloadSweeps(): Promise<void> {
    try {
      const page = await api.sweeps(null);
      store.update((state) => {
        const value = state.sweeps.status === "ready" ? mergeSweeps(state.sweeps.value, page) : page;
        return { ...state, sweeps: { status: "ready", value } };
      });
    } catch (error) {
      store.update((state) => ({ ...state, sweeps: { status: "failed", problem: api.problemOf(error) } }));
    }
  }

  async function loadOlderSweeps(): Promise<void> {
    const { sweeps } = store.get();
    if (sweeps.status !== "ready" || sweeps.value.next_cursor === null) return;
    try {
      const older = await api.sweeps(sweeps.value.next_cursor);
      const value = { sweeps: [...sweeps.value.sweeps, ...older.sweeps], next_cursor: older.next_cursor };
      store.update((state) => ({ ...state, sweeps: { status: "ready", value } }));
    } catch (error) {
      store.update((state) => ({ ...state, sweeps: { status: "failed", problem: api.problemOf(error) } }));
    }
  }

  /** Changes the sweep in view and takes over how it then stands. */
  async function changeOpen(ask: (id: string) => Promise<SweepDetail>): Promise<void> {
    const id = store.get().openSweep?.id;
    if (id === undefined) return;
    const tell = (problem: Problem | null): void =>
      store.update((state) =>
        state.openSweep?.id === id ? { ...state, openSweep: { ...state.openSweep, problem } } : state,
      );
    tell(null);
    try {
      follower.take(id, await ask(id));
      void reloadSweeps();
    } catch (error) {
      tell(api.problemOf(error));
    }
  }

  return {
    editSweep, estimateSweep, submitSweep, reloadSweeps, loadOlderSweeps,
    openSweep: follower.open, closeSweep: follower.close, reopenSweep: follower.reopen,
    cancelSweep: () => changeOpen(api.cancelSweep), resumeSweep: () => changeOpen(api.resumeSweep),
  };
}

function unreadable(detail: string, errors: Fault[]): Problem {
  return { title: "The sweep can't be read.", status: 0, detail, errors };
}
