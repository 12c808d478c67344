import { useRef, useState } from "preact/hooks";
import { ago, moment } from "../../lib/format.ts";
import { formatRoute } from "../../lib/route.ts";
import { isOver, share } from "../../lib/study/point-progress.ts";
import { StateBadge } from "../shared/state-badge.tsx";
import type { EntryProps } from "./entry-props.ts";
import { EntryRename } from "./entry-rename.tsx";
import { EntryTools } from "./entry-tools.tsx";

/** One entry, with its progress while it is at work, and what can be done with it. */
export function SidebarEntry(props: EntryProps) {
  const { of, list, compared = null } = props;
  const [mode, setMode] = useState<"shown" | "tools" | "renaming">("shown");
  const more = useRef<HTMLButtonElement>(null);

  function close(): void {
    setMode("shown");
    more.current?.focus();
  }

  return (
    <li onKeyDown={(event) => event.key === "Escape" && mode !== "shown" && close()}>
      <EntryLink {...props} />
      {compared !== null && (
        <label class="entry-tick" title="Compare">
          <input
            type="checkbox"
            aria-label={`Compare ${of.name}`}
            checked={compared.isTicked}
            onChange={(event) => compared.onTick(event.currentTarget.checked)}
          />
        </label>
      )}
      <button
        ref={more}
        type="button"
        class="entry-more"
        aria-label={`More for ${of.name}`}
        aria-expanded={mode !== "shown"}
        title="Rename, archive, remove"
        onClick={() => setMode(mode === "shown" ? "tools" : "shown")}
      >
        ⋯
      </button>
      {mode === "tools" && <EntryTools {...props} onRename={() => setMode("renaming")} />}
      {mode === "renaming" && <EntryRename name={of.name} save={(name) => list.change(of.id, { name })} onClose={close} />}
    </li>
  );
}

function EntryLink({ of, route, isOpen, now_ms, standing, done, total, note = null }: EntryProps) {
  return (
    <a href={formatRoute(route)} aria-current={isOpen ? "page" : undefined}>
      <span class="entry-name">{of.name}</span>
      {note !== null && <span class="entry-note">{note}</span>}
      <span class="entry-facts">
        <StateBadge state={of.state} />
        <span title={moment(of.created, new Date(now_ms))}>{ago(of.created, new Date(now_ms))}</span>
        {standing !== null && <span>{standing}</span>}
      </span>
      {!isOver(of.state) && (
        <progress max={1} value={share({ total, done })}>
          {done} of {total ?? "?"}
        </progress>
      )}
    </a>
  );
}
