import { address } from "../../../api.ts";
import { fixed, microstrain, significant } from "../../../lib/format.ts";
import { filmWord, sizeWord } from "../../../lib/layouts/layout-words.ts";
import type { SheetFilm } from "../../../wire.ts";
import { ScrollTable, words } from "../../shared/scroll-table.tsx";

const COLUMNS = [
  words("Film"),
  "Angle, °",
  "Arc from the mark, mm",
  "From the bead, mm",
  "From the crown, mm",
  "Along",
  "Size, mm",
  "Connector, mm",
  "Lead, mm",
];

/** What stands above the expected signals: their unit and the depth of the contact. */
function expectedHead([film]: readonly SheetFilm[]): string[] {
  if (film?.expected_depth_mm == null) return [];
  return [`Expected at ${significant(film.expected_depth_mm)} mm, ${film.expected_v == null ? "µε" : "V"}`];
}

/** Where each film goes. */
export function SheetTable({ id, films }: { id: string; films: readonly SheetFilm[] }) {
  return (
    <ScrollTable name="Films to glue" columns={[...COLUMNS, ...expectedHead(films)]} csv={address(id, "export?format=csv&table=films")}>
      <tbody>
        {films.map((film) => (
          <tr key={film.number}>
            <th scope="row">{film.number}</th>
            <td>{fixed(film.theta_deg, 2)}</td>
            <td>{fixed(film.arc_mm, 1)}</td>
            <td>{fixed(film.from_bead_mm, 1)}</td>
            <td>{fixed(film.from_crown_mm, 1)}</td>
            <td>{filmWord(film.direction)}</td>
            <td>{sizeWord(film)}</td>
            <td>{film.connector_arc_mm == null ? "" : `${fixed(film.connector_arc_mm, 1)}; ${fixed(film.connector_from_bead_mm, 1)}`}</td>
            <td>{fixed(film.lead_mm, 0)}</td>
            {film.expected_depth_mm != null && <td>{film.expected_v == null ? microstrain(film.expected_strain) : significant(film.expected_v)}</td>}
          </tr>
        ))}
      </tbody>
    </ScrollTable>
  );
}
