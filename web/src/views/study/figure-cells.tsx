import { type Column, shown, shownError } from "../../lib/study/figures/columns.ts";

/** A row's figures, each with its claimed error where it has one. */
export function FigureCells({ columns, row }: { columns: readonly Column[]; row: unknown }) {
  return (
    <>
      {columns.map((column) => {
        const error = shownError(column, row);
        return (
          <td key={column.at}>
            {shown(column, row)}
            {error !== undefined && <span class="error"> ± {error}</span>}
          </td>
        );
      })}
    </>
  );
}
