import { useState } from "preact/hooks";
import type { Problem } from "../../api.ts";
import { isOver } from "../../lib/study/point-progress.ts";
import { ProblemBox } from "../shared/problem-box.tsx";
import type { EntryProps } from "./entry-props.ts";

/** What can be done with an entry. One that is at work is cancelled on its own page before it can be removed. */
export function EntryTools({ of, kind, isOpen, list, onMoved, onRename }: EntryProps & { onRename: () => void }) {
  const [problem, setProblem] = useState<Problem | null>(null);
  const isArchived = of.archived != null;

  async function archive(): Promise<void> {
    const archived = !isArchived;
    const fault = await list.change(of.id, { archived });
    setProblem(fault);
    if (fault === null) onMoved({ kind, id: of.id, name: of.name, to: archived ? "archive" : "list" });
  }

  function remove(): void {
    if (isOpen) location.hash = "";
    onMoved({ kind, id: of.id, name: of.name, to: "nowhere" });
  }

  return (
    <div class="entry-tools" role="group" aria-label={`For ${of.name}`}>
      <button type="button" aria-label={`Rename ${of.name}`} onClick={onRename}>
        Rename
      </button>
      <button type="button" aria-label={`${isArchived ? "Take back" : "Archive"} ${of.name}`} onClick={() => void archive()}>
        {isArchived ? "Take back" : "Archive"}
      </button>
      {isOver(of.state) && (
        <button type="button" class="entry-remove" aria-label={`Remove ${of.name}`} onClick={remove}>
          Remove
        </button>
      )}
      {problem !== null && <ProblemBox problem={problem} />}
    </div>
  );
}
