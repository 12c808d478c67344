import type { ComponentChildren } from "preact";

interface Props {
  name: string;
  /** Class of the table. */
  kind?: string;
  /** Long, with a head that stays in view. */
  isTall?: boolean;
  children: ComponentChildren;
}

/** A table that is scrolled by itself, with the keyboard too, so that the page never is wider than its window. */
export function ScrollTable({ name, kind, isTall = false, children }: Props) {
  return (
    <div class={isTall ? "scroll tall" : "scroll"} tabIndex={0} role="region" aria-label={name}>
      <table class={kind} aria-label={name}>
        {children}
      </table>
    </div>
  );
}
