import { layoutWords, short } from "../../../lib/layouts/layout-words.ts";
import type { FrontLayout, RankedLayout } from "../../../wire.ts";
import { ScrollTable, words } from "../../shared/scroll-table.tsx";

/** The best that so many films can do. */
export function FrontTable({ front, layouts }: { front: FrontLayout[]; layouts: RankedLayout[] }) {
  if (front.length === 0) return null;
  return (
    <>
      <h3>The best that so many films can do</h3>
      <ScrollTable
        name="Best layout for each number of films"
        columns={["Films", "Angle error, 95 % °", "Force error N", words("Layout that no other beats with as few films")]}
      >
        <tbody>
          {front.map(({ film_count, simulated_p95_angle_error_deg: p95, index }) => {
            const layout = layouts[index];
            return (
              <tr key={film_count}>
                <td>{film_count}</td>
                <td>
                  {short(p95, 3)} <span class="error">± {short(layout?.score.error?.simulated_p95_angle_error_deg, 2)}</span>
                </td>
                <td>{short(layout?.score.force_error_n, 2)}</td>
                <td class="words">{layout !== undefined && layoutWords(layout)}</td>
              </tr>
            );
          })}
        </tbody>
      </ScrollTable>
    </>
  );
}
