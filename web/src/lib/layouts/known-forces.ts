import type { ForceError, ForcePrice, RankedLayout } from "../../wire.ts";

/** A layout and one force that its films tell. */
export interface KnownForce {
  layout: RankedLayout;
  force: ForceError;
}

export const AXIS_WORDS: Record<string, string> = { fx: "along the wheel", fy: "across it", fz: "upwards" };

/** Forces that films tell, by the number of films: what more of them buy. */
export function knownForces(layouts: RankedLayout[]): KnownForce[] {
  const all = layouts.flatMap((layout) => (layout.force_error ?? []).map((force) => ({ layout, force })));
  return all
    .filter(({ force }) => force.useful)
    .sort((a, b) => a.force.axis.localeCompare(b.force.axis) || films(a) - films(b) || a.layout.rank - b.layout.rank);
}

/** Forces that no layout's films tell. */
export function untoldAxes(layouts: RankedLayout[]): string[] {
  const all = layouts.flatMap((layout) => layout.force_error ?? []);
  const axes = [...new Set(all.map((force) => force.axis))];
  return axes.filter((axis) => all.every((force) => force.axis !== axis || !force.useful));
}

/** The layout by which a force is known best on runs with other films. */
export function bestKnown(known: KnownForce[], axis: string): KnownForce | undefined {
  const errors = known.filter(({ force }) => force.axis === axis && force.fresh.rmse_n != null);
  return errors.sort((a, b) => (a.force.fresh.rmse_n ?? 0) - (b.force.fresh.rmse_n ?? 0))[0];
}

/** About the least error of a price's layout that one instant's readings allow, N. */
export function floorOf(known: KnownForce[], price: ForcePrice): number | null | undefined {
  return known.find(({ layout, force }) => layout.rank === price.layout_rank && force.axis === price.axis)?.force.floor_n;
}

/** Least and greatest error by the drift of the readings, its own among them, N; null where no other was tried. */
export function rangeByDrift({ fresh, drift }: ForceError): [number, number] | null {
  const errors = [fresh.rmse_n, ...(drift ?? []).map(({ error }) => error.rmse_n)].filter((error) => error != null);
  return errors.length < 2 ? null : [Math.min(...errors), Math.max(...errors)];
}

function films({ layout }: KnownForce): number {
  return layout.film_count;
}
