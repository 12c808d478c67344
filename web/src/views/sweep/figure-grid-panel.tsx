import * as api from "../../api.ts";
import { css, inkOn, sequential } from "../../lib/chart/colour.ts";
import { CELL_FIGURES, formatRoute, studyRoute, type CellFigure } from "../../lib/route.ts";
import { cellOf, valueRange, type DesignGrid, type GridCell } from "../../lib/sweep/figure-grid.ts";
import { useAsked } from "../../state/use-asked.ts";
import type { Comparison, DesignView, LayoutAnswer } from "../../wire.ts";
import { RadioChoice } from "../shared/radio-choice.tsx";
import { ScrollTable, words } from "../shared/scroll-table.tsx";

const NAMES: Record<CellFigure, string> = {
  answer: "Best place",
  "index-x": "Its index x, %",
  "index-y": "Its index y, %",
  "angle-error": "Best layout's angle error, °",
};

interface Props {
  grid: DesignGrid;
  comparison: Comparison | null;
  figure: CellFigure;
  onFigure: (figure: CellFigure) => void;
}

/** The designs of two fields as a table of one figure, coloured by it. */
export function FigureGridPanel({ grid, comparison, figure, onFigure }: Props) {
  const layouts = useLayouts(figure === "angle-error" ? grid : null);
  const cells = grid.designs.map((row) => row.map((design) => (design === null ? null : { design, cell: cellOf(design, figure, comparison, layouts) })));
  const range = valueRange(cells.flat().flatMap((each) => (each === null ? [] : [each.cell])));
  return (
    <section class="panel" aria-labelledby="grid-title">
      <h2 id="grid-title">The two fields as a grid</h2>
      <div class="controls">
        <RadioChoice
          name="cell-figure"
          legend="Each cell shows"
          options={CELL_FIGURES.map((value) => ({ value, label: NAMES[value] }))}
          chosen={figure}
          onChoose={onFigure}
        />
      </div>
      <ScrollTable
        name="Designs by two fields"
        kind="figure-grid"
        columns={[
          words(
            <>
              <code>{grid.rows.path}</code> down, <code>{grid.columns.path}</code> across
            </>,
          ),
          ...grid.columns.values,
        ]}
      >
        <tbody>
          {cells.map((row, k) => (
            <tr key={grid.rows.values[k]}>
              <th scope="row" class="words">
                {grid.rows.values[k]}
              </th>
              {row.map((each, column) => (each === null ? <td key={column}>no design</td> : <Cell key={each.design.study.id} {...each} range={range} />))}
            </tr>
          ))}
        </tbody>
      </ScrollTable>
      <p class="quiet">
        {WORDS[figure]} {figure !== "answer" && "± ? isn't known, as of a draft. "}Each cell leads to its study.
      </p>
    </section>
  );
}

const WORDS: Record<CellFigure, string> = {
  answer: "First of the ranking, and whether the errors leave no doubt about that.",
  "index-x": "First-order index of the best place's own depth for the x strain at the contact's centre, with its error; dark is least, light is most.",
  "index-y": "First-order index of the best place's own depth for the y strain at the contact's centre, with its error; dark is least, light is most.",
  "angle-error":
    "95 of 100 simulated contacts are estimated better than this by the first of the layouts, at the worst load, with the error of that; dark is least, light is most.",
};

function Cell({ design, cell, range }: { design: DesignView; cell: GridCell; range: [number, number] | null }) {
  const { words, sure, value } = cell;
  const ground = value === null || range === null ? null : sequential(range[1] > range[0] ? (value - range[0]) / (range[1] - range[0]) : 0.5);
  const style = ground === null ? {} : { background: css(ground), color: css(inkOn(ground)) };
  return (
    <td class={ground === null ? "figure-cell" : "figure-cell figure-coloured"} style={style} data-state={design.study.state}>
      <a href={formatRoute(studyRoute(design.study.id))} title={design.name}>
        <strong>{words}</strong>
        {sure !== null && <span class="figure-sure">{sure}</span>}
      </a>
    </td>
  );
}

/** What the designs that are done say of their best layout. Results are large: they are asked for one after the other, without their maps. */
function useLayouts(grid: DesignGrid | null): ReadonlyMap<string, LayoutAnswer | null> {
  const done = grid?.designs.flat().flatMap((design) => (design?.study.state === "done" ? [design.study.id] : [])) ?? [];
  const asked = useAsked(done.length === 0 ? null : done.join(), layoutsOf);
  return asked?.status === "ready" ? asked.value : NOTHING;
}

const NOTHING: ReadonlyMap<string, LayoutAnswer | null> = new Map();

async function layoutsOf(ids: string): Promise<ReadonlyMap<string, LayoutAnswer | null>> {
  const layouts = new Map<string, LayoutAnswer | null>();
  for (const id of ids.split(",")) layouts.set(id, (await api.result(id, false)).answer?.layout ?? null);
  return layouts;
}
