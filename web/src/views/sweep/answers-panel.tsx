import { MISSING, significant } from "../../lib/format.ts";
import { formatRoute, studyRoute } from "../../lib/route.ts";
import { typeset } from "../../lib/study/answer/answer-words.ts";
import { heading, view } from "../../lib/study/figures/columns.ts";
import { answered } from "../../lib/sweep/compared-trades.ts";
import { DESIGNS_COLUMNS, type ComparedStudy, type Comparison } from "../../wire.ts";
import { ScrollTable, words } from "../shared/scroll-table.tsx";
import { FigureCells } from "../study/figure-cells.tsx";
import { VerdictBadge } from "../study/answer/verdict-badge.tsx";
import { ComparedPlot } from "./compared-plot.tsx";

const FIGURES = view(DESIGNS_COLUMNS, "answers");

/** Which study answers best, with which layout: films against error of each, then their figures, best first. */
export function AnswersPanel({ comparison: { answer, studies, baseline }, csv }: { comparison: Comparison; csv: string }) {
  const found = answered(studies);
  const without = studies.filter((study) => study.answer == null);
  return (
    <section class="panel" aria-labelledby="answers-title">
      <h2 id="answers-title">Which answers best</h2>
      {answer != null && (
        <p class="headline">
          {typeset(answer.sentence)} <VerdictBadge verdict={answer.verdict} />
        </p>
      )}
      <ComparedPlot studies={studies} />
      <ScrollTable
        name="Answers of the studies"
        kind="answers"
        isTall
        csv={csv}
        columns={["#", words("Study"), words("Layout"), ...FIGURES.map(heading), words("Best place"), "Load N", words("Mesh")]}
      >
        <tbody>
          {[...found, ...without].map((study) => (
            <Row key={study.id} study={study} isBaseline={study.id === baseline} />
          ))}
        </tbody>
      </ScrollTable>
      <p class="quiet">
        Best first. Angle: 95 of 100 contacts are told better, at the worst load. Force: root mean square. Differences are from the baseline; ★ where the errors
        leave no doubt about one. Load: vertical, at the means.
      </p>
    </section>
  );
}

function Row({ study, isBaseline }: { study: ComparedStudy; isBaseline: boolean }) {
  const { answer, best } = study;
  return (
    <tr class={isBaseline ? "baseline" : undefined}>
      <td>{answer?.rank ?? MISSING}</td>
      <th scope="row" class="words">
        <a href={formatRoute(studyRoute(study.id))}>{study.name}</a>
        {isBaseline && <span class="error"> baseline</span>}
      </th>
      <td class="words">
        {answer?.words ?? study.reason ?? "none asked"}
        {answer?.angle_deg.verdict === "real" && <span title="Its angle differs from the baseline's beyond the errors"> ★</span>}
      </td>
      <FigureCells columns={FIGURES} row={{ study }} />
      <td class="words">{best == null ? "none" : `${best}, ${study.best_certain === true ? "certain" : "uncertain"}`}</td>
      <td>{significant(study.reaction_n)}</td>
      <td class="words">{study.level ?? "none"}</td>
    </tr>
  );
}
