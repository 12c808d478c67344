/** The ranking of a preview beside that of the draft's first one. */

import type { Preview } from "../../../wire.ts";

export interface PreviewRow {
  name: string;
  rank: number;
  /** First-order indices of the place's own depth, percent; null where they don't exist. */
  x: number | null;
  y: number | null;
  /** What they were when the draft began. */
  x_before: number | null;
  y_before: number | null;
  /** Places gained since then; negative: lost. */
  gained: number;
}

/** In the order of their names, so that bars grow and shrink where they stand. */
export function previewRows(preview: Preview, start: Preview | null): PreviewRow[] {
  const before = new Map(start?.locations.map((location) => [location.name, location]));
  return preview.locations
    .map((location): PreviewRow => {
      const old = before.get(location.name);
      return {
        name: location.name,
        rank: location.rank,
        x: location.gsi_x_percent ?? null,
        y: location.gsi_y_percent ?? null,
        x_before: old?.gsi_x_percent ?? null,
        y_before: old?.gsi_y_percent ?? null,
        gained: old === undefined ? 0 : old.rank - location.rank,
      };
    })
    .sort((a, b) => a.name.localeCompare(b.name, "en", { numeric: true }));
}

/** A round number not below a peak: scales that jump seldom let changes be seen. */
export function roundPeak(peak: number): number {
  if (!(peak > 0) || !Number.isFinite(peak)) return 1;
  const power = 10 ** Math.floor(Math.log10(peak));
  return ([1, 1.5, 2, 3, 5, 7, 10].find((factor) => factor * power >= peak * (1 - 1e-9)) ?? 10) * power;
}
