import { duration } from "../../lib/format.ts";
import type { Report } from "../../wire.ts";
import { forceAnswer } from "../../lib/forces/force-words.ts";
import { Facts } from "../shared/facts.tsx";
import { TermLine } from "../shared/term/term.tsx";

/** How far each force is known, and what the intervals promise. */
export function ForceAnswers({ report }: { report: Report }) {
  const { candidates, wall_s } = report.cost;
  return (
    <section class="panel" aria-labelledby="answer-title">
      <h2 id="answer-title" class="hidden">
        Answer
      </h2>
      <div class="force-answers">
        {report.forces.map(forceAnswer).map(({ force, isUseful, sentence, facts }) => (
          <div key={force} class="force-answer" data-force={force}>
            <h3>{force}</h3>
            <p class={isUseful ? "force-sentence" : "force-sentence force-useless"}>{sentence.charAt(0).toUpperCase() + sentence.slice(1)}.</p>
            {facts.length > 0 && <Facts facts={facts} />}
          </div>
        ))}
      </div>
      <p class="promise">{report.promise.charAt(0).toUpperCase() + report.promise.slice(1)}.</p>
      <TermLine names={["training mean", "blend", "95 % interval", "leak factor"]} />
      <p class="quiet">
        {candidates} models judged in {duration(wall_s)}. In brackets: 95 % of the bootstrap's samples of whole cycles.
      </p>
    </section>
  );
}
