import { template } from "../../../api.ts";
import { firstOf, leadOf } from "../../../lib/study/answer/answer-words.ts";
import { useAsked } from "../../../state/use-asked.ts";
import { Loaded } from "../../shared/loaded.tsx";
import { VerdictBadge } from "../answer/verdict-badge.tsx";
import type { SectionProps } from "../section-props.ts";
import { FilmTemplate } from "./film-template.tsx";
import { SheetTable } from "./sheet-table.tsx";

/** What is taken to the tire: where each film goes, in a table and at true scale. */
export function SheetView({ result, study }: SectionProps) {
  const answer = result.answer ?? null;
  const films = answer?.films ?? [];
  const drawn = useAsked(films.length === 0 ? null : study.id, template);
  if (answer === null || drawn === null) {
    return (
      <section class="panel" aria-labelledby="sheet-title">
        <h2 id="sheet-title">Gluing sheet</h2>
        <p>The answer names no films.</p>
      </section>
    );
  }
  return (
    <section class="panel sheet" aria-labelledby="sheet-title">
      <h2 id="sheet-title">Gluing sheet</h2>
      <p class="headline">{firstOf(answer.sentence)}</p>
      <p>
        <VerdictBadge verdict={answer.verdict} /> {leadOf(answer.reason)}
      </p>
      <p class="actions">
        <button type="button" disabled={drawn.status !== "ready"} onClick={() => window.print()}>
          Print
        </button>
      </p>
      <SheetTable id={study.id} films={films} />
      <p class="quiet">
        Angles and arcs count from the mark, in the rolling direction; all arcs lie on the inner surface, to the film's middle. x runs around the wheel, y from
        bead to bead. A connector is told by its arc from the mark and from the bead: it is at the end nearer to a bead, or ahead. A lead runs from there
        straight to the bead, and along it to the mark.
      </p>
      <section class="template" aria-labelledby="template-title">
        <h3 id="template-title">Template, 1:1</h3>
        <p>Print at 100 %, not fitted to the page. The bar must measure 100 mm.</p>
        <Loaded of={drawn} what="the template" onRetry={() => location.reload()}>
          {(svg) => <FilmTemplate svg={svg} />}
        </Loaded>
      </section>
    </section>
  );
}
