import type { ComponentChildren } from "preact";
import { useRef } from "preact/hooks";
import { csvOf, fileName } from "../../lib/shell/file-names.ts";
import { save } from "./picture/picture-file.ts";

/** What stands above a column of figures, or of something else. */
export type Column = string | { text: ComponentChildren; class?: string; title?: string };

/** Above a column of words. */
export const words = (text: ComponentChildren): Column => ({ text, class: "words" });

interface Props {
  name: string;
  /** One row of heads; left out where there are more, which the children have. */
  columns?: readonly Column[];
  /** Class of the table. */
  kind?: string;
  /** Long, with a head that stays in view. */
  isTall?: boolean;
  /** Address of the table as the service exports it, with all digits; without one what is shown can be saved. */
  csv?: string;
  children: ComponentChildren;
}

/** A table that is scrolled by itself, with the keyboard too, so that the page never is wider than its window. */
export function ScrollTable({ name, columns, kind, isTall = false, csv, children }: Props) {
  const table = useRef<HTMLTableElement>(null);

  function saveShown(): void {
    const rows = [...(table.current?.rows ?? [])].map((row) => [...row.cells].map((cell) => cell.innerText));
    save(new Blob([csvOf(rows)], { type: "text/csv" }), fileName("table", name, "csv"));
  }

  return (
    <>
      <div class={isTall ? "scroll tall" : "scroll"} tabIndex={0} role="group" aria-label={`${name}, scrolled sideways`}>
        <table ref={table} class={kind} aria-label={name}>
          {columns !== undefined && <Heads of={columns} />}
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

function Heads({ of }: { of: readonly Column[] }) {
  return (
    <thead>
      <tr>
        {of.map((column, k) => {
          const { text, ...head } = typeof column === "string" ? { text: column } : column;
          return (
            <th key={k} scope="col" {...head}>
              {text}
            </th>
          );
        })}
      </tr>
    </thead>
  );
}
