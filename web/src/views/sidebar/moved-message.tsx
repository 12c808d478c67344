import { useLayoutEffect, useRef } from "preact/hooks";
import type { Moved } from "../../state/app-state.ts";
import { SEARCH_ID } from "./list-search.tsx";

/** Says where an entry went that has just left its list, and takes it back. The focus that was on it comes here. */
export function MovedMessage({ moved, onUndo, onClose }: { moved: Moved | null; onUndo: (moved: Moved) => Promise<void>; onClose: () => void }) {
  const undo = useRef<HTMLButtonElement>(null);
  useLayoutEffect(() => undo.current?.focus(), [moved]);

  async function takeBack(entry: Moved): Promise<void> {
    await onUndo(entry);
    document.getElementById(SEARCH_ID)?.focus();
  }

  function close(): void {
    onClose();
    document.getElementById(SEARCH_ID)?.focus();
  }

  return (
    <div role="status">
      {moved !== null && (
        <p class="moved">
          <span>
            “{moved.name}” is {moved.archived ? "archived" : "back in the list"}.
          </span>
          <button ref={undo} type="button" class="small-button" onClick={() => void takeBack(moved)}>
            Undo
          </button>
          <button type="button" class="plain" aria-label="Close the message" onClick={close}>
            ×
          </button>
        </p>
      )}
    </div>
  );
}
