import { useLayoutEffect, useRef } from "preact/hooks";
import type { Moved } from "../../state/app-state.ts";
import { SEARCH_ID } from "./list-search.tsx";

const WORDS: Record<Moved["to"], string> = { archive: "archived", list: "back in the list", nowhere: "removed with its results" };

interface Props {
  moved: readonly Moved[];
  onUndo: (moved: Moved) => Promise<void>;
  onClose: (moved: Moved) => void;
}

/** Says where entries went that have left their list, and takes them back. The focus that was on one comes here, and stays until the last is answered. */
export function MovedMessages({ moved, onUndo, onClose }: Props) {
  const place = useRef<HTMLDivElement>(null);
  const before = useRef(moved);
  useLayoutEffect(() => {
    if (moved === before.current) return;
    before.current = moved;
    (place.current?.querySelector<HTMLElement>(".moved:last-child button") ?? document.getElementById(SEARCH_ID))?.focus();
  }, [moved]);

  return (
    <div ref={place} role="status">
      {moved.map((entry) => (
        <p key={entry.id} class="moved">
          <span>
            “{entry.name}” is {WORDS[entry.to]}.
          </span>
          <button type="button" class="small-button" aria-label={`Undo: ${entry.name}`} onClick={() => void onUndo(entry)}>
            Undo
          </button>
          <button type="button" class="plain" aria-label={`Close the message on ${entry.name}`} onClick={() => onClose(entry)}>
            ×
          </button>
        </p>
      ))}
    </div>
  );
}
