/** Cells of CSV files, as the service writes them: quoted as RFC 4180 asks, and such that no spreadsheet takes a name for a formula. */

/** Begins of formulas, and white space that a spreadsheet takes off before it looks; apostrophes in front are left aside. */
const FORMULA = /^'*[=+\-@\t\r\n]/;

const isFormula = (text: string): boolean => FORMULA.test(text) && !Number.isFinite(Number(text));

/** The cell of a text, with an apostrophe in front where a spreadsheet would compute it. */
export function csvCell(text: string): string {
  const shielded = isFormula(text) ? `'${text}` : text;
  return /[,;\t"\n\r]/.test(text) ? `"${shielded.replaceAll('"', '""')}"` : shielded;
}

/** The text of a cell without its quotes: the other way of csvCell. */
export function csvText(cell: string): string {
  const text = cell.slice(1);
  return cell.startsWith("'") && isFormula(text) ? text : cell;
}
