import { fixed, significant } from "../../../lib/format.ts";
import { tauMatrix } from "../../../lib/layouts/film-criteria.ts";
import { filmWord, short, sizeWord } from "../../../lib/layouts/layout-words.ts";
import type { CandidateFilm, OrderAgreement } from "../../../wire.ts";
import { ScrollTable } from "../../shared/scroll-table.tsx";

/** Kinds of film by several criteria, and how far these order them alike. */
export function CandidateFilms({ films, agreement, csv }: { films: CandidateFilm[]; agreement: OrderAgreement[]; csv: string }) {
  if (films.length === 0) return null;
  const best = Math.max(...films.map((film) => film.angle_information));
  const rows = [...films].sort((a, b) => b.angle_information - a.angle_information);
  return (
    <>
      <h3>Which film tells most</h3>
      <ScrollTable name="Kinds of film by several criteria" csv={csv}>
        <thead>
          <tr>
            <th scope="col">Section angle °</th>
            <th scope="col">Direction</th>
            <th scope="col">Size mm</th>
            <th scope="col">Information on the angle 1/°</th>
            <th scope="col">Information on the depth 1/mm</th>
            <th scope="col">Largest signal</th>
            <th scope="col">Effective independence</th>
            <th scope="col">Pivot</th>
            <th scope="col">Deviation at the centre</th>
          </tr>
        </thead>
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
              <td>{significant(film.effective_independence)}</td>
              <td>{film.pivot_rank ?? "adds nothing"}</td>
              <td>{significant(film.centre_std)}</td>
            </tr>
          ))}
        </tbody>
      </ScrollTable>
      <p class="quiet">
        One film of each kind, over a whole turn and all loads. Signals are strains, or volts of glued films. The deviation at the centre of the contact is what the
        paper ranks by.
      </p>
      <Agreement agreement={agreement} />
    </>
  );
}

function Agreement({ agreement }: { agreement: OrderAgreement[] }) {
  const { criteria, tau } = tauMatrix(agreement);
  if (criteria.length === 0) return null;
  return (
    <>
      <h3>How far these criteria agree</h3>
      <ScrollTable name="Kendall's tau between criteria" kind="matrix">
        <thead>
          <tr>
            <td />
            {criteria.map((name) => (
              <th key={name} scope="col">
                {name}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {criteria.map((name, k) => (
            <tr key={name}>
              <th scope="row">{name}</th>
              {tau[k]?.map((value, j) => <td key={j}>{j === k ? "" : fixed(value, 2)}</td>)}
            </tr>
          ))}
        </tbody>
      </ScrollTable>
      <p class="quiet">Kendall's tau: 1 the same order, 0 none in common, −1 the reverse.</p>
    </>
  );
}
