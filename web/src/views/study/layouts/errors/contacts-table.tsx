import { layoutWords, short } from "../../../../lib/layouts/layout-words.ts";
import type { ContactFindings, RankedLayout, ToldQuantity } from "../../../../wire.ts";
import { ScrollTable, words } from "../../../shared/scroll-table.tsx";
import { ErrorRow } from "./error-row.tsx";

/** What contacts as they come do to a layout: each quantity alone, and all of them, at the load where that is worst. */
export function ContactsTable({ layout, contacts }: { layout: RankedLayout | undefined; contacts: ContactFindings | null | undefined }) {
  const alone = layout?.contacts ?? [];
  if (layout === undefined || contacts == null || alone.length === 0) return null;
  const [rms, largest] = [contacts.slope_error_rms, contacts.slope_error_largest];
  const within = (claim: number | null | undefined) => (claim == null ? "" : ` (95 % within ${short(100 * claim)} %)`);
  const slopes =
    rms == null || largest == null
      ? ""
      : `, their slopes over the angle by ${short(100 * rms)} % of its steepest${within(contacts.slope_claim)} and ${short(100 * largest)} % at most`;
  return (
    <>
      <h3>What makes the error of {layoutWords(layout)}</h3>
      <ScrollTable name="Errors by contacts" columns={[words("Contacts that differ in"), "Angle, 95 %, °", "Force, rms, N"]}>
        <tbody>
          {alone.map((own) => (
            <ErrorRow
              key={own.of}
              of={own.of === "noise" ? "nothing: noise alone" : `${own.words} alone`}
              angle={own.p95_angle_error_deg}
              force={own.force_error_n}
            />
          ))}
          <ErrorRow of="all of it" angle={layout.score.simulated_p95_angle_error_deg} force={layout.worst_force?.error_n} />
        </tbody>
      </ScrollTable>
      <ToldQuantities told={layout.told ?? []} />
      <p class="quiet">
        Each at the load where it is worst. Errors are over {contacts.laws.join(", ")}; the estimate knows their laws, not their values. Signals of contacts
        come from few solves: they are off by {short(100 * contacts.signal_error_rms)} % of the crown's largest, root mean square
        {within(contacts.signal_claim)}, and by {short(100 * contacts.signal_error_largest)} % at most{slopes}, at {contacts.checks} contacts that they weren't
        made from.
        {(contacts.short ?? []).map((each) => ` Drawn no further than could be solved: ${each}.`)}
      </p>
    </>
  );
}

/** What films tell of a contact beside angle and force. */
function ToldQuantities({ told }: { told: readonly ToldQuantity[] }) {
  if (told.length === 0) return null;
  return (
    <ScrollTable name="What films tell of contacts" columns={[words("Films tell of"), "Error, rms", "±", "Deviation", words("So")]}>
      <tbody>
        {told.map((own) => (
          <tr key={own.of}>
            <th scope="row">{own.words}</th>
            <td>{short(own.error)}</td>
            <td>{own.claim == null ? "" : short(own.claim)}</td>
            <td>{short(own.deviation)}</td>
            <td class="words">{own.known ? "known" : "can't be told"}</td>
          </tr>
        ))}
      </tbody>
    </ScrollTable>
  );
}
