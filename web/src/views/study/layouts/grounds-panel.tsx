import { address } from "../../../api.ts";
import type { LayoutFindings, StudyResult } from "../../../wire.ts";
import { CandidateFilms } from "./candidate-films.tsx";
import { FrontTable } from "./front-table.tsx";
import { KneesTable } from "./knees-table.tsx";
import { SearchesTable } from "./searches-table.tsx";
import { ShearTable } from "./shear-table.tsx";

/** What the order of layouts rests on. */
export function GroundsPanel({ result, findings }: { result: StudyResult; findings: LayoutFindings }) {
  const { layouts, study } = result;
  const rows = [...layouts].sort((a, b) => a.rank - b.rank);
  const searches = findings.searches ?? [];
  return (
    <section class="panel layouts" aria-labelledby="grounds-title">
      <h2 id="grounds-title">What the order rests on</h2>
      <FrontTable front={findings.front} layouts={layouts} />
      <ShearTable layouts={rows} loads={findings.loads} />
      <KneesTable loads={findings.loads} />
      {searches.length > 0 && <SearchesTable searches={searches} layouts={rows} />}
      <CandidateFilms films={findings.candidates} csv={address(study.id, "export?format=csv&table=candidates")} />
    </section>
  );
}
