import { heading, view } from "../../../lib/study/figures/columns.ts";
import { rankWords } from "../../../lib/format.ts";
import { layoutWords, short } from "../../../lib/layouts/layout-words.ts";
import { type LayoutLoad, LAYOUTS_COLUMNS, type RankedLayout } from "../../../wire.ts";
import { FigureCells } from "../figure-cells.tsx";
import { ScrollTable, words } from "../../shared/scroll-table.tsx";

/** Layouts that are listed: the best ones. */
const SHOWN = 20;

const FIGURES = view(LAYOUTS_COLUMNS, "shear");

/** What is known with forces along and across the wheel unknown, too. */
export function ShearTable({ layouts, loads }: { layouts: RankedLayout[]; loads: LayoutLoad[] }) {
  const rows = layouts.filter((layout) => layout.score.shear != null).slice(0, SHOWN);
  const load = loads.find((each) => each.shear != null);
  if (rows.length === 0 || load?.shear == null) return null;
  const [along, across] = load.shear.slopes_n_per_mm;
  const telling = layouts.find((layout) => layout.score.shear != null && layout.score.shear.reason == null);
  return (
    <>
      <h3>With forces along and across the wheel unknown</h3>
      <p>
        {telling === undefined ? (
          "No layout tells them at its worst load."
        ) : (
          <>
            The best layout that tells them at its worst load is <strong>{layoutWords(telling)}</strong>, at rank {telling.rank}.
          </>
        )}
      </p>
      <ScrollTable name="Layouts with shear unknown" columns={["Rank", words("Layout"), ...FIGURES.map(heading), words("What can't be told")]}>
        <tbody>
          {rows.map((layout, k) => (
            <Row key={k} layout={layout} rank={rankWords(layout.rank, layouts)} />
          ))}
        </tbody>
      </ScrollTable>
      <p class="quiet">
        Cramér–Rao bounds at the worst contact angle and the layout's worst load, about a contact that isn't dragged. Dragged a little, the ground pulls{" "}
        {short(along)} N/mm along the wheel and {short(across)} N/mm across it at {short(load.load_n)} N, and slides from {short(load.shear.sliding_n)} N on.
      </p>
    </>
  );
}

function Row({ layout, rank }: { layout: RankedLayout; rank: string }) {
  return (
    <tr>
      <td class="rank">{rank}</td>
      <th scope="row" class="words layout-name">
        {layoutWords(layout)}
      </th>
      <FigureCells columns={FIGURES} row={{ layout }} />
      <td class="words">{layout.score.shear?.reason ?? ""}</td>
    </tr>
  );
}
