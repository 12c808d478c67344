import { address } from "../../../api.ts";
import { answersLayout } from "../../../lib/study/result-picks.ts";
import type { LayoutFindings, StudyResult } from "../../../wire.ts";
import { GluedNote } from "../forces/glued-note.tsx";
import { AssumptionsTable } from "./errors/assumptions-table.tsx";
import { ContactsTable } from "./errors/contacts-table.tsx";
import { LayoutAnswer } from "./layout-answer.tsx";
import { LayoutErrors } from "./layout-errors.tsx";
import { RankedLayouts } from "./ranked-layouts.tsx";

/** Layouts around the whole wheel: the best one first, then all of them in their order. */
export function LayoutsPanel({ result, findings }: { result: StudyResult; findings: LayoutFindings | null }) {
  const { layouts, study } = result;
  if (layouts.length === 0 || findings === null) return null;
  const rows = [...layouts].sort((a, b) => a.rank - b.rank);
  const csv = address(study.id, "export?format=csv&table=layouts");
  return (
    <section class="panel layouts" aria-labelledby="layouts-title">
      <h2 id="layouts-title">Layouts around the wheel</h2>
      <LayoutAnswer layouts={rows} answers={answersLayout(result)} />
      {(findings.reasons ?? []).map((reason) => (
        <p key={reason} class="flag">
          {reason}
        </p>
      ))}
      <LayoutErrors study={study.name} layouts={rows} loads={findings.loads} />
      <AssumptionsTable layout={answersLayout(result) ?? rows[0]} assumptions={findings.assumptions} />
      <ContactsTable layout={answersLayout(result) ?? rows[0]} contacts={findings.contacts} />
      {findings.films != null && <GluedNote films={findings.films} />}
      <RankedLayouts layouts={rows} findings={findings} csv={csv} />
    </section>
  );
}
