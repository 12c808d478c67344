import { useEffect, useRef, useState } from "preact/hooks";
import { KEYS } from "../../lib/shell/page/page-keys.ts";
import { TERMS } from "../../lib/shell/terms.ts";
import { hasSingleKeys, setSingleKeys } from "../../state/preferences.ts";

/** The keys of the page, over it until it is closed. */
export function KeyDialog({ onClose }: { onClose: () => void }) {
  const dialog = useRef<HTMLDialogElement>(null);
  const [isOn, setOn] = useState(hasSingleKeys);
  useEffect(() => dialog.current?.showModal(), []);

  function change(next: boolean): void {
    setSingleKeys(next);
    setOn(next);
  }

  return (
    <dialog ref={dialog} class="key-dialog" aria-labelledby="keys-title" onClose={onClose}>
      <h2 id="keys-title">Keys and terms</h2>
      <dl>
        {KEYS.map(({ keys, does }) => (
          <div key={does}>
            <dt>
              <kbd>{keys}</kbd>
            </dt>
            <dd>{does}</dd>
          </div>
        ))}
      </dl>
      <label>
        <input type="checkbox" checked={isOn} onChange={(event) => change(event.currentTarget.checked)} /> Single keys work: ? and 1 to 6
      </label>
      <details class="term-list">
        <summary>All terms, in a sentence or two</summary>
        <dl>
          {Object.entries(TERMS).map(([name, meaning]) => (
            <div key={name}>
              <dt>{name}</dt>
              <dd>{meaning}</dd>
            </div>
          ))}
        </dl>
      </details>
      <div class="actions">
        <button type="button" class="primary" onClick={() => dialog.current?.close()}>
          Close
        </button>
      </div>
    </dialog>
  );
}
