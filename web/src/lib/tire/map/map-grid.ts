/** Values on a grid of angles, and what lies between its points: the one way in which map, tire and reading interpolate. */

export interface MapGrid {
  /** Angles of the columns from the contact centre, degrees. */
  theta_deg: readonly number[];
  /** Angles of the rows from the crown, degrees. */
  phi_deg: readonly number[];
}

/** A place on the inner surface of the undeformed tire. */
export interface SurfacePoint {
  theta_deg: number;
  phi_deg: number;
}

/** Where a value lies on an axis: between point `at` and the next, `share` of the way. */
export interface Bracket {
  at: number;
  share: number;
}

/** A grid point and how much it counts. */
export interface Corner {
  index: number;
  weight: number;
}

/** Rounding that still counts as on the edge, degrees. */
const EDGE = 1e-9;

/** The interval of an ascending axis that holds a value; null outside. */
export function bracket(axis: readonly number[], value: number): Bracket | null {
  const [first, last] = [axis[0], axis[axis.length - 1]];
  if (first === undefined || last === undefined || !(value >= first - EDGE && value <= last + EDGE)) return null;
  if (axis.length === 1) return { at: 0, share: 0 };
  let [low, high] = [0, axis.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((axis[middle] as number) <= value) low = middle;
    else high = middle;
  }
  const [from, to] = [axis[low] as number, axis[high] as number];
  return { at: low, share: Math.min(1, Math.max(0, (value - from) / (to - from))) };
}

/** The grid points around a place that count there; null outside the grid. */
export function cornersAt(grid: MapGrid, { theta_deg, phi_deg }: SurfacePoint): Corner[] | null {
  const [column, row] = [bracket(grid.theta_deg, theta_deg), bracket(grid.phi_deg, phi_deg)];
  return column === null || row === null ? null : cornersOf(grid.theta_deg.length, row, column);
}

/** The four grid points of two brackets, without those that don't count. */
export function cornersOf(columns: number, row: Bracket, column: Bracket): Corner[] {
  const start = row.at * columns + column.at;
  return [
    { index: start, weight: (1 - row.share) * (1 - column.share) },
    { index: start + 1, weight: (1 - row.share) * column.share },
    { index: start + columns, weight: row.share * (1 - column.share) },
    { index: start + columns + 1, weight: row.share * column.share },
  ].filter(({ weight }) => weight > 0);
}

/** The bilinear value between grid points; the nearest one's where one of them has none. */
export function interpolate(values: readonly (number | null)[], corners: readonly Corner[]): number | null {
  let sum = 0;
  for (const { index, weight } of corners) {
    const value = values[index];
    if (value == null) return values[nearest(corners)] ?? null;
    sum += weight * value;
  }
  return sum;
}

/** The grid point that counts most. */
export function nearest(corners: readonly Corner[]): number {
  return corners.reduce((best, corner) => (corner.weight > best.weight ? corner : best)).index;
}

/** The grid point next to a place in a direction of steps, kept on the grid. */
export function stepped(grid: MapGrid, from: SurfacePoint, columns: number, rows: number): SurfacePoint {
  return { theta_deg: along(grid.theta_deg, from.theta_deg, columns), phi_deg: along(grid.phi_deg, from.phi_deg, rows) };
}

function along(axis: readonly number[], value: number, steps: number): number {
  const near = axis.reduce((best, each, index) => (Math.abs(each - value) < Math.abs((axis[best] as number) - value) ? index : best), 0);
  return axis[Math.min(axis.length - 1, Math.max(0, near + steps))] ?? value;
}

/** Whether two places are one. */
export function isSamePlace(a: SurfacePoint | null, b: SurfacePoint | null): boolean {
  return a !== null && b !== null && a.theta_deg === b.theta_deg && a.phi_deg === b.phi_deg;
}
