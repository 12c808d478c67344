import type { ComponentChildren } from "preact";
import { useId } from "preact/hooks";
import { TERMS, type TermName } from "../../../lib/shell/terms.ts";

/** A word that says what it means when it is pressed; Escape, or a press elsewhere, closes that, as the browser does for every popover. */
export function Term({ of, children }: { of: TermName; children?: ComponentChildren }) {
  const id = `term${useId()}`;
  return (
    <span>
      <button type="button" class="term-word" popovertarget={id}>
        {children ?? of}
      </button>
      <span id={id} popover="auto" class="term-text">
        {TERMS[of]}
      </span>
    </span>
  );
}

/** The words of a view that have no other place in it. */
export function TermLine({ names }: { names: readonly TermName[] }) {
  return (
    <p class="quiet">
      Words here:{" "}
      {names.map((name, k) => (
        <span key={name}>
          {k > 0 && ", "}
          <Term of={name} />
        </span>
      ))}
      .
    </p>
  );
}
