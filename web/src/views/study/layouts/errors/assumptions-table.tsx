import { layoutWords } from "../../../../lib/layouts/layout-words.ts";
import type { AssumptionFindings, RankedLayout } from "../../../../wire.ts";
import { ScrollTable, words } from "../../../shared/scroll-table.tsx";
import { ErrorRow } from "./error-row.tsx";

/** What the figures of the layout that answers rest on: each assumption changed alone, the one that moves them most first. */
export function AssumptionsTable({ layout, assumptions }: { layout: RankedLayout | undefined; assumptions: AssumptionFindings | null | undefined }) {
  if (layout === undefined || assumptions == null) return null;
  const { angle_error_deg: angle, force_error_n: force, changes, unchanged } = assumptions;
  return (
    <>
      <h3>What the figures of {layoutWords(layout)} rest on</h3>
      <ScrollTable name="Errors by assumptions" columns={[words("With"), "Angle, 95 %, °", "Force, rms, N"]}>
        <tbody>
          <ErrorRow of="all as assumed" angle={angle} force={force} />
          {changes.map((change) => (
            <ErrorRow key={change.of} of={change.words} angle={change.angle_error_deg} force={change.force_error_n} />
          ))}
        </tbody>
      </ScrollTable>
      <p class="quiet">
        One is changed at a time, each figure is at the load where it is worst. An estimate knows how far readings scatter; of another scene it knows nothing.
        {unchanged.length > 0 && ` Not changed: ${unchanged.join(", ")}; layouts.assumptions names values.`}
      </p>
    </>
  );
}
