import { significant } from "../../../lib/format.ts";
import { filmWord, short, sizeWord } from "../../../lib/layouts/layout-words.ts";
import type { CandidateFilm } from "../../../wire.ts";
import { ScrollTable } from "../../shared/scroll-table.tsx";

/** Kinds of film by several criteria. */
export function CandidateFilms({ films, csv }: { films: CandidateFilm[]; csv: string }) {
  if (films.length === 0) return null;
  const best = Math.max(...films.map((film) => film.angle_information));
  const rows = [...films].sort((a, b) => b.angle_information - a.angle_information);
  return (
    <>
      <h3>Which film tells most</h3>
      <ScrollTable
        name="Kinds of film by several criteria"
        csv={csv}
        columns={["Section angle °", "Direction", "Size mm", "Information on the angle 1/°", "Information on the depth 1/mm", "Largest signal"]}
      >
        <tbody>
          {rows.map((film) => (
            <tr key={`${film.section_deg} ${film.direction} ${sizeWord(film)}`}>
              <th scope="row">{short(film.section_deg)}</th>
              <td>{filmWord(film.direction)}</td>
              <td>{sizeWord(film)}</td>
              <td class={film.angle_information === best ? "best" : undefined}>
                {significant(film.angle_information)}
                {film.angle_information_error != null && <span class="error"> ± {significant(film.angle_information_error, 2)}</span>}
              </td>
              <td>{significant(film.depth_information)}</td>
              <td>{significant(film.signal)}</td>
            </tr>
          ))}
        </tbody>
      </ScrollTable>
      <p class="quiet">One film of each kind, over a whole turn and all loads. Signals are strains, or volts of glued films.</p>
    </>
  );
}
