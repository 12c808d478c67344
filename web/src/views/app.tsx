import { useEffect, useState } from "preact/hooks";
import { formatRoute, type Route } from "../lib/route.ts";
import { actionOf } from "../lib/shell/page/page-keys.ts";
import type { Actions } from "../state/actions.ts";
import type { AppState } from "../state/app-state.ts";
import { hasSingleKeys } from "../state/preferences.ts";
import { later } from "./shared/later.tsx";
import { KeyDialog } from "./shell/key-dialog.tsx";
import { Masthead } from "./shell/masthead.tsx";
import { Missing } from "./shell/missing.tsx";
import { useTitle } from "./shell/use-title.ts";
import { StudyList } from "./sidebar/study-list.tsx";
import { SweepList } from "./sidebar/sweep-list.tsx";
import { StudyPage } from "./study/study-page.tsx";

const ComparePage = later("the comparison", async () => (await import("./compare/compare-page.tsx")).ComparePage);
const EstimatorPage = later("the estimator", async () => (await import("./forces/estimator-page.tsx")).EstimatorPage);
const ForcesPage = later("the forces", async () => (await import("./forces/forces-page.tsx")).ForcesPage);
const OwnPage = later("your model", async () => (await import("./own/own-page.tsx")).OwnPage);
const StudyForm = later("the form", async () => (await import("./home/study-form.tsx")).StudyForm);
const SweepPage = later("the sweep", async () => (await import("./sweep/sweep-page.tsx")).SweepPage);

/** The whole page. What it is opened for comes before the lists and the links on top, for those who go by Tab. */
export function App({ state, actions }: { state: AppState; actions: Actions }) {
  const { route } = state;
  const [isHelp, setHelp] = useState(false);
  useTitle(state);
  useEffect(() => listenForKeys(route, () => setHelp(true)), [route]);
  return (
    <div class={route.view === "home" ? "page page-home" : "page page-study"}>
      <a class="skip" href="#main" onClick={skipToContent}>
        Skip to the content
      </a>
      <main id="main" tabIndex={-1}>
        {route.view === "home" && <StudyForm state={state} actions={actions} />}
        {route.view === "compare" && <ComparePage state={state} route={route} actions={actions} />}
        {route.view === "estimator" && <EstimatorPage state={state} route={route} actions={actions} />}
        {route.view === "forces" && <ForcesPage state={state} actions={actions} />}
        {route.view === "nowhere" && <Missing what="Page" why={`The address ${route.address} names no page.`} />}
        {route.view === "own" && <OwnPage />}
        {route.view === "study" && <StudyPage state={state} route={route} actions={actions} />}
        {route.view === "sweep" && <SweepPage state={state} route={route} actions={actions} />}
      </main>
      <aside id="lists" class="sidebar" aria-label="Sweeps and studies" tabIndex={-1}>
        <SweepList state={state} actions={actions} />
        <StudyList state={state} actions={actions} />
      </aside>
      <Masthead route={route} onHelp={() => setHelp(true)} />
      {isHelp && <KeyDialog onClose={() => setHelp(false)} />}
    </div>
  );
}

/** To the section that is open, below its links. The hash is the route, so the link moves the focus itself. */
function skipToContent(event: Event): void {
  event.preventDefault();
  (document.getElementById("section") ?? document.getElementById("main"))?.focus();
}

function listenForKeys(route: Route, onHelp: () => void): () => void {
  function press(event: KeyboardEvent): void {
    if (!hasSingleKeys() || document.querySelector("dialog[open]") !== null) return;
    const isTyping = event.target instanceof Element && event.target.closest("input, textarea, select, [contenteditable]") !== null;
    const action = actionOf({ key: event.key, isModified: event.ctrlKey || event.altKey || event.metaKey, isTyping }, route);
    if (action?.does === "help") onHelp();
    if (action?.does === "open" && route.view === "study") location.hash = formatRoute({ ...route, section: action.section });
  }
  window.addEventListener("keydown", press);
  return () => window.removeEventListener("keydown", press);
}
