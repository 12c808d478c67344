import { address } from "../../../api.ts";
import { fixed } from "../../../lib/format.ts";
import { filmWord, sizeWord } from "../../../lib/layouts/layout-words.ts";
import type { SheetFilm } from "../../../wire.ts";
import { ScrollTable, words } from "../../shared/scroll-table.tsx";

const COLUMNS = [words("Film"), "Angle, °", "Arc from the mark, mm", "From the bead, mm", "From the crown, mm", "Along", "Size, mm"];

/** Where each film goes. */
export function SheetTable({ id, films }: { id: string; films: readonly SheetFilm[] }) {
  return (
    <ScrollTable name="Films to glue" columns={COLUMNS} csv={address(id, "export?format=csv&table=films")}>
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
          </tr>
        ))}
      </tbody>
    </ScrollTable>
  );
}
