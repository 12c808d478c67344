import { different } from "../../../lib/study/signals/film-curves.ts";
import type { ClaimRow } from "../../../wire.ts";
import { ScrollTable, words } from "../../shared/scroll-table.tsx";

/** What holds of what is claimed: a row for each film's place, a column for each claim and model of the film. */
export function ClaimsTable({ tire, claims }: { tire: string; claims: ClaimRow[] }) {
  const films = different(claims.map((row) => row.film));
  const kinds = different(claims.map((row) => row.claim));
  const places = different(claims.map((row) => `${row.position} ${row.direction}`));
  return (
    <ScrollTable
      name={`Claims about the ${tire} tire`}
      columns={[words(`${tire} tire`), ...films.flatMap((film) => kinds.map((claim) => words(`${film}: ${claim}`)))]}
    >
      <tbody>
        {places.map((place) => (
          <tr key={place}>
            <th scope="row">{place}</th>
            {films.flatMap((film) =>
              kinds.map((claim) => {
                const of = (row: ClaimRow): boolean => row.film === film && row.claim === claim && `${row.position} ${row.direction}` === place;
                return <Verdict key={`${film} ${claim}`} row={claims.find(of)} />;
              }),
            )}
          </tr>
        ))}
      </tbody>
    </ScrollTable>
  );
}

function Verdict({ row }: { row: ClaimRow | undefined }) {
  return (
    <td class="words">
      {row !== undefined && (
        <>
          <strong>{row.holds}</strong>: {row.detail}
        </>
      )}
    </td>
  );
}
