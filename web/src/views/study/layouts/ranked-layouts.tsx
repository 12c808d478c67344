import { useState } from "preact/hooks";
import { heading, view } from "../../../lib/study/figures/columns.ts";
import { MISSING, rankWords } from "../../../lib/format.ts";
import { filmsWords, layoutWords, LOST_DEG, short } from "../../../lib/layouts/layout-words.ts";
import { type LayoutFindings, LAYOUTS_COLUMNS, type RankedLayout } from "../../../wire.ts";
import { FigureCells } from "../figure-cells.tsx";
import { ScrollTable, words } from "../../shared/scroll-table.tsx";
import { Term } from "../../shared/term/term.tsx";

/** Rows before one asks for more. */
const FEW = 20;

const FIGURES = view(LAYOUTS_COLUMNS, "ranked", "dead", "bound", "alike");
const HEADS = ["Rank", words("Certain"), words("Layout"), ...FIGURES.map(heading)];

/** Every layout at its worst load, best first. */
export function RankedLayouts({ layouts, findings, csv }: { layouts: RankedLayout[]; findings: LayoutFindings; csv: string }) {
  const [isWhole, setWhole] = useState(false);
  const rows = isWhole ? layouts : layouts.slice(0, FEW);
  return (
    <>
      <h3>All layouts, best first</h3>
      <ScrollTable name="Ranked layouts" kind="ranked-layouts" isTall={isWhole} csv={csv} columns={HEADS}>
        <tbody>
          {rows.map((layout, k) => (
            <Row key={k} layout={layout} rank={rankWords(layout.rank, layouts)} />
          ))}
        </tbody>
      </ScrollTable>
      {layouts.length > FEW && (
        <button type="button" aria-expanded={isWhole} onClick={() => setWhole(!isWhole)}>
          {isWhole ? `Show the best ${FEW}` : `Show all ${layouts.length} layouts`}
        </button>
      )}
      <p class="quiet">
        Ranked by the simulated <Term of="95 % of contacts">95th percentile</Term> of the angle error at the layout's worst load, times the root of its number
        of films: another film must bring more than an average of more readings. Layouts whose 95th percentile is beyond {LOST_DEG}° come last.{" "}
        <Term of="lost share">Lost</Term>: off by more than {LOST_DEG}°. Worst load: that of the angle. Angle bound:{" "}
        <Term of="Cramér–Rao bound">Cramér–Rao</Term>, at the worst angle and load. Most alike: the two contacts more than {LOST_DEG}° apart whose readings
        differ least, in standard deviations of the noise; below about 3 they are mistaken for each other. Force: root mean square at the load where that is
        largest, by the depth's error; what films learn of forces stands under Forces.
        {findings.tau_of_bound != null && ` The order by the bound agrees with this one with Kendall's tau of ${short(findings.tau_of_bound, 2)}.`}{" "}
        {filmsWords(findings.size_mm, findings.unit)} Mesh: {findings.level}
        {findings.coarser_level == null ? ", without a coarser one for its error." : `, its error from ${findings.coarser_level}.`}
      </p>
    </>
  );
}

function Row({ layout, rank }: { layout: RankedLayout; rank: string }) {
  const doubt = layout.doubt ?? layout.score.reason;
  return (
    <tr>
      <td class="rank">{rank}</td>
      <td class="words">{layout.rank_certain == null ? MISSING : layout.rank_certain ? "yes" : "no"}</td>
      <th scope="row" class="words layout-name">
        {layoutWords(layout)}
        {doubt != null && <span class="layout-doubt">{doubt}</span>}
      </th>
      <FigureCells columns={FIGURES} row={{ layout }} />
    </tr>
  );
}
