import { integer } from "../../../lib/format.ts";
import { placesWords, short, withPlaces } from "../../../lib/layouts/layout-words.ts";
import type { LayoutSearch, RankedLayout } from "../../../wire.ts";
import { ScrollTable } from "../../shared/scroll-table.tsx";

/** The best places that a search found for so many films. */
export function SearchesTable({ searches, layouts }: { searches: LayoutSearch[]; layouts: RankedLayout[] }) {
  return (
    <>
      <h3>Best places for so many films, by search</h3>
      <ScrollTable name="Searched layouts">
        <thead>
          <tr>
            <th scope="col">Films</th>
            <th scope="col" class="words">
              Best places: section angle, direction, angles around the wheel
            </th>
            <th scope="col">Bound, rms °</th>
            <th scope="col">Simulated, 95 % °</th>
            <th scope="col">Rank</th>
            <th scope="col" class="words">
              Search
            </th>
          </tr>
        </thead>
        <tbody>
          {searches.map((search) => {
            const layout = withPlaces(layouts, search.best);
            return (
              <tr key={search.films}>
                <td>{search.films}</td>
                <td class="words">{placesWords(search.best)}</td>
                <td>{short(search.bayes_angle_error_deg)}</td>
                <td>
                  {short(layout?.score.simulated_p95_angle_error_deg)}{" "}
                  <span class="error">± {short(layout?.score.error?.simulated_p95_angle_error_deg, 2)}</span>
                </td>
                <td>{layout?.rank}</td>
                <td class="words">
                  {search.method}, {integer(search.looked_at)} layouts on {search.places} places
                </td>
              </tr>
            );
          })}
        </tbody>
      </ScrollTable>
      <p class="quiet">
        Searched by the bound with a flat prior over angles and loads, which doesn't see every contact that is mistaken for another: the simulation beside it does.
      </p>
    </>
  );
}
