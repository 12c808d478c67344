import { ago, integer, moment } from "../../lib/format.ts";
import type { EstimatorSummary } from "../../wire.ts";
import { estimatorRoute, formatRoute } from "../../lib/route.ts";
import { ScrollTable, words } from "../shared/scroll-table.tsx";
import { StateBadge } from "../shared/state-badge.tsx";

/** Newest first. */
export function EstimatorTable({ estimators, now_ms }: { estimators: readonly EstimatorSummary[]; now_ms: number }) {
  const now = new Date(now_ms);
  return (
    <ScrollTable name="Estimators" kind="designs" columns={[words("Name"), { text: "State", class: "state" }, words("Forces"), "Runs", "Rows", "Submitted"]}>
      <tbody>
        {estimators.map(({ id, name, state, error, forces, recordings, created, progress }) => (
          <tr key={id}>
            <th scope="row" class="words">
              <a href={formatRoute(estimatorRoute(id))}>{name}</a>
            </th>
            <td class="state">
              <StateBadge state={state} />
              {progress != null && progress.of > 0 && (
                <span class="error">
                  {" "}
                  {progress.done} of {progress.of}
                </span>
              )}
            </td>
            <td class={error == null ? "words" : "words reason"}>{error ?? forces.join(", ")}</td>
            <td>{recordings.length}</td>
            <td>{integer(recordings.reduce((sum, { rows }) => sum + rows, 0))}</td>
            <td title={moment(created, now)}>{ago(created, now)}</td>
          </tr>
        ))}
      </tbody>
    </ScrollTable>
  );
}
