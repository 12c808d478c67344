import { fixed } from "../../../lib/format.ts";
import type { FilmAnglesReport } from "../../../wire.ts";

/** Glued films beside the contact: how far they are off, and would be without their own solves. */
export function GluedNote({ films }: { films: FilmAnglesReport }) {
  const off =
    films.signal_worst == null
      ? "not tested"
      : `off by ${fixed(100 * films.signal_worst, 1)} % of full scale at most, ${fixed(100 * (films.signal_rms ?? 0), 1)} % rms, at ${films.tested} solves between them`;
  return (
    <p class="quiet">
      Glued films are solved with the tire on the {films.level} mesh at {films.angles_deg.length} angles from the contact: {off}. Their transfer alone would be
      off by {fixed(100 * films.transfer_worst, 1)} %.
    </p>
  );
}
