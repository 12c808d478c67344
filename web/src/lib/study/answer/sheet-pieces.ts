/** The template to glue by, cut so that paper holds it. */

/** What paper holds between the sheet's margins below a heading, A4 or Letter, mm. */
const PAPER_MM = 245;

/** A strip's outline in the template, mm from its top. */
export interface StripOutline {
  y_mm: number;
  height_mm: number;
}

/** What is printed without a break: a strip, or a part of one that is higher than paper. */
export interface SheetPiece extends StripOutline {
  strip: number;
}

/** The template from top to bottom: cut midway between strips, and a strip that paper doesn't hold in equal parts. */
export function sheetPieces(height_mm: number, strips: readonly StripOutline[], paper_mm = PAPER_MM): SheetPiece[] {
  const cuts = strips.map(({ y_mm }, k) => {
    const above = strips[k - 1];
    return above === undefined ? 0 : (above.y_mm + above.height_mm + y_mm) / 2;
  });
  return cuts.flatMap((y_mm, strip) => {
    const whole = (cuts[strip + 1] ?? height_mm) - y_mm;
    const parts = Math.ceil(whole / paper_mm);
    return Array.from({ length: parts }, (_, part) => ({ strip, y_mm: y_mm + (part * whole) / parts, height_mm: whole / parts }));
  });
}
