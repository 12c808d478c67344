import type { LayoutFindings, RankedLayout } from "../../../wire.ts";
import { BoundsTable } from "./bounds-table.tsx";
import { CandidateFilms } from "./candidate-films.tsx";
import { FrontTable } from "./front-table.tsx";
import { KneesTable } from "./knees-table.tsx";
import { LayoutAnswer } from "./layout-answer.tsx";
import { LayoutErrors } from "./layout-errors.tsx";
import { RankedLayouts } from "./ranked-layouts.tsx";
import { SearchesTable } from "./searches-table.tsx";

/** Layouts around the whole wheel: the best one first, then what the order rests on. */
export function LayoutsPanel({ layouts, findings }: { layouts: RankedLayout[]; findings: LayoutFindings | null }) {
  if (layouts.length === 0) return null;
  const rows = [...layouts].sort((a, b) => a.rank - b.rank);
  return (
    <section class="panel layouts" aria-labelledby="layouts-title">
      <h2 id="layouts-title">Layouts around the wheel</h2>
      {findings === null ? <BoundsTable layouts={rows} /> : <Simulated layouts={rows} inOrder={layouts} findings={findings} />}
    </section>
  );
}

function Simulated(props: { layouts: RankedLayout[]; inOrder: RankedLayout[]; findings: LayoutFindings }) {
  const { layouts, inOrder, findings } = props;
  const searches = findings.searches ?? [];
  return (
    <>
      <LayoutAnswer layouts={layouts} />
      {(findings.reasons ?? []).map((reason) => (
        <p key={reason} class="flag">
          {reason}
        </p>
      ))}
      <LayoutErrors layouts={layouts} loads={findings.loads} />
      <FrontTable front={findings.front} layouts={inOrder} />
      <RankedLayouts layouts={layouts} findings={findings} />
      <KneesTable loads={findings.loads} />
      {searches.length > 0 && <SearchesTable searches={searches} layouts={layouts} />}
      <CandidateFilms films={findings.candidates} agreement={findings.agreement} />
    </>
  );
}
