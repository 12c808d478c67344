import { useLayoutEffect, useRef, useState } from "preact/hooks";
import type { Problem } from "../../api.ts";
import { ProblemBox } from "../shared/problem-box.tsx";

interface Props {
  name: string;
  /** Why it can't be called so. */
  save: (name: string) => Promise<Problem | null>;
  onClose: () => void;
}

/** Another name for an entry: Enter saves it, Escape leaves it as it was. */
export function EntryRename({ name, save, onClose }: Props) {
  const input = useRef<HTMLInputElement>(null);
  const [problem, setProblem] = useState<Problem | null>(null);
  // Before anything else is typed: the button that had the focus is gone.
  useLayoutEffect(() => input.current?.select(), []);

  async function submit(event: Event): Promise<void> {
    event.preventDefault();
    const typed = input.current?.value.trim() ?? "";
    const fault = typed === name ? null : await save(typed);
    if (fault === null) return onClose();
    // The sentence of the field says more than that of the whole.
    setProblem({ ...fault, detail: fault.errors?.[0] === undefined ? (fault.detail ?? "") : `The name ${fault.errors[0].detail}.` });
    input.current?.focus();
  }

  return (
    <form class="entry-tools" aria-label={`Rename ${name}`} onSubmit={(event) => void submit(event)}>
      <input ref={input} class="line" aria-label={`New name of ${name}`} aria-invalid={problem !== null} defaultValue={name} required maxLength={200} />
      <button type="submit">Save</button>
      <button type="button" onClick={onClose}>
        Cancel
      </button>
      {problem !== null && <ProblemBox problem={problem} />}
    </form>
  );
}
