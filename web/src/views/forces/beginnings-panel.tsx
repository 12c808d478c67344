import { newtons } from "../../lib/forces/force-words.ts";
import type { BeginningsReport, ForceReport } from "../../wire.ts";
import { ScrollTable } from "../shared/scroll-table.tsx";

/** What a begin under load, or a zero after lifting, does to runs that were left out; nothing where none was. */
export function BeginningsPanel({ force }: { force: ForceReport }) {
  const { beginnings } = force;
  if (beginnings == null) return null;
  return (
    <section class="panel" aria-labelledby="beginnings-title">
      <h2 id="beginnings-title">Where a run begins</h2>
      <p>{beginnings.advice}</p>
      <BeginningsTable beginnings={beginnings} />
      <p class="quiet">
        RMSE of {force.force} on runs that weren't learnt from, begun elsewhere than they were recorded: under a quarter, half and all of their largest force,
        and zeroed so long after the force was lifted. Beside it the same rows of the same runs as recorded.
      </p>
    </section>
  );
}

function BeginningsTable({ beginnings: { loaded, rested } }: { beginnings: BeginningsReport }) {
  const rows = [
    ...loaded.map((one) => ({ begun: `under ${newtons(one.load_n)} N`, ...one })),
    ...rested.map((one) => ({ begun: `zeroed ${one.rest_s} s after lifting`, ...one })),
  ];
  return (
    <ScrollTable name="Where a run begins">
      <thead>
        <tr>
          <th scope="col" class="words">
            Begun
          </th>
          <th scope="col">RMSE, N</th>
          <th scope="col">As recorded, N</th>
        </tr>
      </thead>
      <tbody>
        {rows.map((row) => (
          <tr key={row.begun}>
            <th scope="row" class="words">
              {row.begun}
            </th>
            <td>{newtons(row.rmse_n)}</td>
            <td>{newtons(row.recorded_rmse_n)}</td>
          </tr>
        ))}
      </tbody>
    </ScrollTable>
  );
}
