import { microstrain, significant } from "../../lib/format.ts";
import { formatRoute, studyRoute } from "../../lib/route.ts";
import type { ComparedStudy } from "../../wire.ts";
import { ScrollTable, words } from "../shared/scroll-table.tsx";

/** What each study found, in a row. */
export function AnswersTable({ studies }: { studies: ComparedStudy[] }) {
  return (
    <section class="panel" aria-labelledby="answers-title">
      <h2 id="answers-title">What they found</h2>
      <ScrollTable
        name="Answers of the studies"
        kind="answers"
        columns={["#", words("Study"), words("Best place"), words("Best layout"), "Force, N", "Signal x, µε", "Signal y, µε", words("Mesh")]}
      >
        <tbody>
          {studies.map((study, index) => (
            <tr key={study.id}>
              <td>{index + 1}</td>
              <th scope="row" class="words">
                <a href={formatRoute(studyRoute(study.id))}>{study.name}</a>
              </th>
              <td class="words">{study.best == null ? (study.reason ?? "none") : `${study.best}, ${study.best_certain === true ? "certain" : "uncertain"}`}</td>
              <td class="words">
                {study.layout_spacing_deg == null ? "none asked" : `every ${study.layout_spacing_deg}°, ${study.layout_position ?? "free"}`}
              </td>
              <td>{significant(study.reaction_n)}</td>
              <td>{microstrain(study.std_strain_x)}</td>
              <td>{microstrain(study.std_strain_y)}</td>
              <td class="words">{study.level ?? "none"}</td>
            </tr>
          ))}
        </tbody>
      </ScrollTable>
      <p class="quiet">Force: vertical, at the means. Signal: standard deviation of the strain at the centre.</p>
    </section>
  );
}
