/** The draft in the address: it can be reloaded, sent, and gone back in. */

import { changedFields, editsOf } from "../../lib/document/draft-edits.ts";
import { parseDraft } from "../../lib/document/draft-text.ts";
import { filmsFrom, withFreeLayout } from "../../lib/layouts/moving/moved-films.ts";
import { formatRoute, homeRoute, type HomeRoute } from "../../lib/route.ts";
import type { Origin, StudyDraft } from "../app-state.ts";
import type { Store } from "../store.ts";

/** Longer addresses are cut by what sends them. */
const LONGEST = 8000;
/** Between two writes: browsers refuse more than 100 in 30 s. */
const APART_MS = 350;
/** Edits of a field that come sooner after one another are one step back. */
const STEP_MS = 1000;

interface DraftAddress {
  /** Whether the draft is what this address leads to. */
  isOf(route: HomeRoute): boolean;
  /** The draft is shown as the address has it. */
  settle(): void;
  /** The reader changed the draft: soon a new step of the history, or the newest one's end. */
  write(): void;
  /** What is to be written is, at once. */
  flush(): void;
}

export function createDraftAddress(store: Store): DraftAddress {
  /** The draft at the address, at the newest edit, and the edit that waits to be written. */
  let [settled, last] = [homeRoute(), homeRoute()];
  let waiting: { route: HomeRoute; isStep: boolean } | null = null;
  let address = "";
  let field = "";
  let [edited_ms, written_ms] = [0, 0];
  let timer: number | undefined;

  function put(route: HomeRoute, isStep: boolean): void {
    address = formatRoute(route);
    if (isStep) history.pushState(null, "", address);
    else history.replaceState(null, "", address);
    store.update((state) => ({ ...state, route }));
    written_ms = Date.now();
  }

  function settle(): void {
    window.clearTimeout(timer);
    waiting = null;
    field = "";
    const { route, studyDraft } = store.get();
    if (route.view !== "home") return;
    settled = last = routeOf(studyDraft) ?? route;
    // The form's plain address leads to the draft as it was left.
    if (isPlain(route) && address !== "") put(last, false);
    else address = formatRoute(route);
  }

  function write(): void {
    const route = routeOf(store.get().studyDraft);
    if (route === null || formatRoute(route).length > LONGEST) return;
    const changed = route.preset === last.preset && route.again === last.again ? changedFields(last.edits, route.edits) : "origin";
    if (changed === "") return;
    const now = Date.now();
    const isStep = changed !== field || now - edited_ms > STEP_MS || waiting?.isStep === true;
    [last, field, edited_ms, waiting] = [route, changed, now, { route, isStep }];
    window.clearTimeout(timer);
    if (now - written_ms >= APART_MS) flush();
    else timer = window.setTimeout(flush, written_ms + APART_MS - now);
  }

  function flush(): void {
    const { route } = store.get();
    if (waiting === null || route.view !== "home") return;
    // So that the step back leads to the draft before the first edit.
    if (isPlain(route)) put(settled, false);
    put(waiting.route, waiting.isStep);
    waiting = null;
  }

  return { isOf: (route) => isPlain(route) || formatRoute(route) === address, settle, write, flush };
}

/** The document that the edits of an address are made to. */
export function baseOf({ document, films }: Origin): unknown {
  const moved = filmsFrom(films);
  return moved === null ? document : withFreeLayout(document, moved);
}

/** An address that says nothing of the draft. */
function isPlain({ preset, again }: HomeRoute): boolean {
  return preset === null && again === null;
}

/** Null of a text that is no document, and of a document that no address can say. */
function routeOf({ text, origin, preset }: StudyDraft): HomeRoute | null {
  const parsed = parseDraft(text);
  if (origin === null || "fault" in parsed) return null;
  const edits = editsOf(baseOf(origin), parsed.document);
  return edits === null ? null : { ...homeRoute(), preset, again: origin.study, films: origin.films, edits };
}
