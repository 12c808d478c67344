import { studyRoute } from "../../lib/route.ts";
import type { Actions } from "../../state/actions.ts";
import type { AppState } from "../../state/app-state.ts";
import { SidebarEntry, SidebarList } from "./sidebar-list.tsx";

export function StudyList({ state, actions }: { state: AppState; actions: Actions }) {
  const { route, studies, now_ms } = state;
  const openId = route.view === "study" ? route.id : null;
  return (
    <SidebarList title="Studies" kind="study-list" list={studies} actions={actions.studies} empty="No study yet. Pick a preset and run it.">
      {(study) => {
        const [done, total] = [study.points_done, study.points_total ?? null];
        const standing = total === null ? null : `${done}/${total} points`;
        const place = { route: studyRoute(study.id), isOpen: study.id === openId, now_ms, list: actions.studies };
        return <SidebarEntry key={study.id} of={study} {...place} standing={standing} done={done} total={total} />;
      }}
    </SidebarList>
  );
}
