import type { ComponentChildren } from "preact";
import { useRef } from "preact/hooks";
import { csvOf, fileName } from "../../lib/shell/file-names.ts";
import { save } from "./picture-file.ts";

interface Props {
  name: string;
  /** Class of the table. */
  kind?: string;
  /** Long, with a head that stays in view. */
  isTall?: boolean;
  /** Address of the table as the service exports it, with all digits; without one what is shown can be saved. */
  csv?: string;
  children: ComponentChildren;
}

/** A table that is scrolled by itself, with the keyboard too, so that the page never is wider than its window. */
export function ScrollTable({ name, kind, isTall = false, csv, children }: Props) {
  const table = useRef<HTMLTableElement>(null);

  function saveShown(): void {
    const rows = [...(table.current?.rows ?? [])].map((row) => [...row.cells].map((cell) => cell.innerText));
    save(new Blob([csvOf(rows)], { type: "text/csv" }), fileName("table", name, "csv"));
  }

  return (
    <>
      <div class={isTall ? "scroll tall" : "scroll"} tabIndex={0} role="group" aria-label={`${name}, scrolled sideways`}>
        <table ref={table} class={kind} aria-label={name}>
          {children}
        </table>
      </div>
      <p class="as-file">
        {csv === undefined ? (
          <button type="button" aria-label={`Save ${name} as CSV, as shown`} onClick={saveShown}>
            CSV
          </button>
        ) : (
          <a href={csv} aria-label={`${name} as CSV`}>
            CSV
          </a>
        )}
      </p>
    </>
  );
}
