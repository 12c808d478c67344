import { useMemo } from "preact/hooks";
import { compareRoute, formatRoute, studyRoute } from "../../lib/route.ts";
import { differenceNotes } from "../../lib/study/progress/namesakes.ts";
import type { Actions } from "../../state/actions.ts";
import type { AppState, Moved } from "../../state/app-state.ts";
import { ListSearch } from "./list-search.tsx";
import { MovedMessages } from "./moved-messages.tsx";
import { SidebarEntry } from "./sidebar-entry.tsx";
import { SidebarList } from "./sidebar-list.tsx";

export function StudyList({ state, actions }: { state: AppState; actions: Actions }) {
  const { route, studies, now_ms, browsing } = state;
  const { documents, ticked } = browsing;
  const notes = useMemo(
    () => (studies.status === "ready" ? differenceNotes(studies.value.entries, documents) : new Map<string, string>()),
    [studies, documents],
  );
  const openId = route.view === "study" ? route.id : null;

  async function undo(moved: Moved): Promise<void> {
    const { kind, id, to } = moved;
    const problem = to === "nowhere" ? null : await actions[kind].change(id, { archived: to === "list" });
    if (problem === null) actions.browsing.takeBack(moved);
    await actions[kind].reload();
  }

  return (
    <>
      <SidebarList
        title="Studies"
        kind="study-list"
        list={studies}
        browsing={browsing}
        actions={actions.studies}
        head={
          <>
            <ListSearch browsing={browsing} actions={actions.browsing} studies={studies} />
            <MovedMessages moved={browsing.moved} onUndo={undo} onClose={actions.browsing.leave} />
          </>
        }
        empty="No study yet. Pick a preset and run it."
      >
        {(study) => {
          const [done, total] = [study.points_done, study.points_total ?? null];
          const standing = study.brief ?? (total === null ? null : `${done}/${total} points`);
          const place = { route: studyRoute(study.id), isOpen: study.id === openId, now_ms, list: actions.studies, kind: "studies" as const };
          const onTick = (on: boolean): void => actions.browsing.tick(study.id, on);
          const compared = study.state === "done" ? { isTicked: ticked.includes(study.id), onTick } : null;
          const told = { standing, done, total, compared, note: notes.get(study.id) ?? null };
          return <SidebarEntry key={study.id} of={study} {...place} {...told} onMoved={actions.browsing.tellMoved} />;
        }}
      </SidebarList>
      {ticked.length > 0 && (
        <p class="compare-ticked">
          {ticked.length === 1 ? "Tick another study to compare." : <a href={formatRoute(compareRoute(ticked))}>Compare {ticked.length} studies</a>}
        </p>
      )}
    </>
  );
}
