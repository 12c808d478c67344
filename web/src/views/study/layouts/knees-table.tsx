import { MISSING } from "../../../lib/format.ts";
import { kneeRows } from "../../../lib/layouts/knee-rows.ts";
import { loadWords, short } from "../../../lib/layouts/layout-words.ts";
import type { Knee, LayoutLoad } from "../../../wire.ts";
import { ScrollTable, words } from "../../shared/scroll-table.tsx";

/** From how many units on a ring is dense enough, by section angle and films, for each load. */
export function KneesTable({ loads }: { loads: LayoutLoad[] }) {
  const rows = kneeRows(loads);
  if (rows.length === 0) return null;
  return (
    <>
      <h3>From how many units on</h3>
      <ScrollTable
        name="From how many units on a ring is dense enough"
        columns={[
          words("Section angle from the crown, films"),
          ...loads.map((load) => ({
            text: (
              <>
                {loadWords(load)}
                {load.reason != null && <span class="layout-doubt">{load.reason}</span>}
              </>
            ),
          })),
        ]}
      >
        <tbody>
          {rows.map(({ place, knees }) => (
            <tr key={place}>
              <th scope="row">{place}</th>
              {knees.map((knee, k) => (
                <td key={k}>{knee === null ? MISSING : <Units knee={knee} />}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </ScrollTable>
      <p class="quiet">
        From so many units on, more of them bring no more than their number: the worst bound of the angle times the root of the number of units stays within
        twice that of a dense ring. Beside it: how many times that of a dense ring it is at 60°.
      </p>
    </>
  );
}

function Units({ knee: { units, of_60_deg } }: { knee: Knee }) {
  return (
    <>
      <strong>{units ?? "more than were tried"}</strong> <span class="error">(60°: {of_60_deg == null ? "blind" : `× ${short(of_60_deg, 2)}`})</span>
    </>
  );
}
