/** Borders between cells: midpoints, and half a cell beyond the ends. */
export function borders(centres: readonly number[]): number[] {
  const first = centres[0] ?? 0;
  const last = centres[centres.length - 1] ?? 0;
  if (centres.length < 2) return [first - 0.5, last + 0.5];
  const inner = centres.slice(1).map((centre, index) => (centre + (centres[index] as number)) / 2);
  const start = inner[0] as number;
  const end = inner[inner.length - 1] as number;
  return [2 * first - start, ...inner, 2 * last - end];
}
