import { formatRoute } from "../lib/route.ts";
import type { Actions } from "../state/actions.ts";
import type { AppState } from "../state/app-state.ts";
import { StudyForm } from "./home/study-form.tsx";
import { StudyList } from "./sidebar/study-list.tsx";
import { SweepList } from "./sidebar/sweep-list.tsx";
import { StudyPage } from "./study/study-page.tsx";
import { SweepPage } from "./sweep/sweep-page.tsx";

const HOME = formatRoute({ view: "home", preset: null });

/** The whole page. */
export function App({ state, actions }: { state: AppState; actions: Actions }) {
  const isHome = state.route.view === "home";
  return (
    <div class={isHome ? "page page-home" : "page page-study"}>
      <a class="skip" href="#main" onClick={skipToMain}>
        Skip to the content
      </a>
      <header class="masthead">
        <a class="brand" href={HOME}>
          <span class="brand-name">strainsite</span>
          <span class="brand-line">where to glue strain films in a tire, and how sure that is</span>
        </a>
        <nav aria-label="Service">
          <a href={HOME} aria-current={isHome ? "page" : undefined}>
            New study
          </a>
        </nav>
      </header>
      <aside class="sidebar" aria-label="Sweeps and studies">
        <SweepList state={state} actions={actions} />
        <StudyList state={state} actions={actions} />
      </aside>
      <main id="main" tabIndex={-1}>
        {state.route.view === "home" && (
          <StudyForm draft={state.studyDraft} sweep={state.sweepDraft} presets={state.presets} actions={actions} />
        )}
        {state.route.view === "study" && <StudyPage state={state} route={state.route} actions={actions} />}
        {state.route.view === "sweep" && <SweepPage state={state} route={state.route} actions={actions} />}
      </main>
    </div>
  );
}

/** The hash is the route, so the link moves the focus itself. */
function skipToMain(event: Event): void {
  event.preventDefault();
  document.getElementById("main")?.focus();
}
