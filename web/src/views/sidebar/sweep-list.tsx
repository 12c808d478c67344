import { sweepRoute } from "../../lib/route.ts";
import { designsOf, designsOver } from "../../lib/sweep/design-progress.ts";
import type { Actions } from "../../state/actions.ts";
import type { AppState } from "../../state/app-state.ts";
import { SidebarEntry } from "./sidebar-entry.tsx";
import { SidebarList } from "./sidebar-list.tsx";

export function SweepList({ state, actions }: { state: AppState; actions: Actions }) {
  const { route, sweeps, now_ms } = state;
  const openId = route.view === "sweep" ? route.id : null;
  return (
    <SidebarList title="Sweeps" kind="sweep-list" list={sweeps} browsing={state.browsing} actions={actions.sweeps} empty={null}>
      {(sweep) => {
        const [done, total] = [designsOver(sweep), designsOf(sweep)];
        const standing = `${sweep.counts.done}/${total} designs`;
        const place = { route: sweepRoute(sweep.id), isOpen: sweep.id === openId, now_ms, list: actions.sweeps, kind: "sweeps" as const };
        return <SidebarEntry key={sweep.id} of={sweep} {...place} standing={standing} done={done} total={total} onMoved={actions.browsing.tellMoved} />;
      }}
    </SidebarList>
  );
}
