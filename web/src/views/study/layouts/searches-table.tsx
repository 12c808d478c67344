import { integer } from "../../../lib/format.ts";
import { placesWords, short, withPlaces } from "../../../lib/layouts/layout-words.ts";
import type { LayoutSearch, RankedLayout } from "../../../wire.ts";
import { ScrollTable, words } from "../../shared/scroll-table.tsx";

/** The best places that a search found for so many films. */
export function SearchesTable({ searches, layouts }: { searches: LayoutSearch[]; layouts: RankedLayout[] }) {
  return (
    <>
      <h3>Best places for so many films, by search</h3>
      <ScrollTable
        name="Searched layouts"
        columns={[
          "Films",
          words("Best places: section angle, direction, angles around the wheel"),
          "Bound, rms °",
          "Simulated, 95 % °",
          "Rank",
          words("Search"),
        ]}
      >
        <tbody>
          {searches.map((search) => {
            const layout = withPlaces(layouts, search.best);
            return (
              <tr key={`${search.films} ${search.criterion}`}>
                <td>{search.films}</td>
                <td class="words">{placesWords(search.best)}</td>
                <td>{short(search.bayes_angle_error_deg)}</td>
                <td>
                  {short(layout?.score.simulated_p95_angle_error_deg)}{" "}
                  <span class="error">± {short(layout?.score.error?.simulated_p95_angle_error_deg, 2)}</span>
                </td>
                <td>{layout?.rank}</td>
                <td class="words">
                  by {search.criterion}, {search.method}, {integer(search.looked_at)} layouts on {search.places} places
                </td>
              </tr>
            );
          })}
        </tbody>
      </ScrollTable>
      <p class="quiet">
        By bound: the bound of the angle with a flat prior over angles and loads, which knows nothing of contacts that are mistaken for others. By interval
        errors: beside it, the chance that a contact at the least load is taken for one more than 20° off. The simulation beside both decides.
      </p>
    </>
  );
}
