import type { Direction } from "../../../../lib/direction.ts";
import { fixed, MISSING, significant } from "../../../../lib/format.ts";
import type { SignalFilm } from "../../../../lib/tire/surface/signal-films.ts";
import { ScrollTable, words } from "../../../shared/scroll-table.tsx";

/** What the coloured films read: a row for each position, a column for each angle from the contact. */
export function FilmVolts({ films, direction }: { films: readonly SignalFilm[]; direction: Direction }) {
  const positions = [...new Set(films.map(({ position }) => position))];
  const angles = [...new Set(films.map(({ contact_deg }) => contact_deg))].sort((a, b) => a - b);
  return (
    <>
      <ScrollTable
        name={`Volts of films along ${direction}`}
        kind="film-volts"
        columns={[words("V, from the contact"), ...angles.map((angle) => `${fixed(angle, Number.isInteger(angle) ? 0 : 1)}°`)]}
      >
        <tbody>
          {positions.map((position) => (
            <tr key={position}>
              <th scope="row" class="words">
                {position}
              </th>
              {angles.map((angle) => (
                <td key={angle}>{voltsOf(films.find((film) => film.position === position && film.contact_deg === angle))}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </ScrollTable>
      <p class="quiet">
        ± is the estimated error; ± ? isn't known, as of a draft. The ground of these solves is flat, so a film ahead of the contact reads what one behind it
        reads; one of them is drawn.
      </p>
    </>
  );
}

function voltsOf(film: SignalFilm | undefined): string {
  if (film === undefined) return MISSING;
  return `${significant(film.volts)} ± ${film.error === null ? "?" : significant(film.error, 2)}`;
}
