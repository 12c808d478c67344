import { useMemo } from "preact/hooks";
import { directionName, DIRECTIONS } from "../../lib/direction.ts";
import type { Shown } from "../../lib/route.ts";
import { designAxis, matrixOf, realDifferences, type Matrix } from "../../lib/sweep/comparison-matrix.ts";
import type { Comparison } from "../../wire.ts";
import { Notes } from "../shared/notes-panel.tsx";
import { RadioChoice, type Option } from "../shared/radio-choice.tsx";
import { TermLine } from "../shared/term/term.tsx";
import { ComparisonChart, MarkKey } from "./comparison-chart.tsx";
import { DifferenceTable, RankTable } from "./comparison-tables.tsx";

const SHOWN: readonly Option<Shown>[] = [
  { value: "index", label: "Index" },
  { value: "difference", label: "Difference" },
];

interface Props {
  comparison: Comparison;
  shown: Shown;
  /** Absent where the baseline is chosen elsewhere on the page. */
  onBaseline?: (study: string) => void;
  onShown: (shown: Shown) => void;
}

/** What differs between the designs, and which differences are real. */
export function ComparisonPanel({ comparison, shown, onBaseline, onShown }: Props) {
  // The page's clock ticks every second, thousands of marks and cells needn't.
  const matrix = useMemo(() => matrixOf(comparison), [comparison]);
  const axis = useMemo(() => designAxis(comparison.studies.map(({ set }) => ({ set: set ?? {} }))), [comparison]);
  const charts = useMemo(
    () => DIRECTIONS.map((direction) => <ComparisonChart key={direction} matrix={matrix} axis={axis} direction={direction} shown={shown} />),
    [matrix, axis, shown],
  );
  const tables = useMemo(() => <Tables matrix={matrix} />, [matrix]);
  return (
    <>
      <Notes notes={comparison.notes} />
      {matrix.rows.length > 0 && (
        <section class="panel comparison" aria-labelledby="comparison-title">
          <h2 id="comparison-title">What differs</h2>
          <div class="controls">
            {onBaseline !== undefined && <BaselineChoice matrix={matrix} onChoose={onBaseline} />}
            <RadioChoice name="shown" legend="Charts show" isLegendHidden options={SHOWN} chosen={shown} onChoose={onShown} />
          </div>
          <Summary matrix={matrix} />
          <div class="charts">{charts}</div>
          <MarkKey shown={shown} />
          {tables}
        </section>
      )}
    </>
  );
}

function BaselineChoice({ matrix, onChoose }: { matrix: Matrix; onChoose: (study: string) => void }) {
  return (
    <label>
      Differences from{" "}
      <select value={matrix.baseline ?? ""} onChange={(event) => onChoose(event.currentTarget.value)}>
        {matrix.baseline === null && (
          <option value="" disabled>
            a design that has no result
          </option>
        )}
        {matrix.rows.map(({ study, number }) => (
          <option key={study.id} value={study.id}>
            {number}: {study.name}
          </option>
        ))}
      </select>
    </label>
  );
}

function Summary({ matrix }: { matrix: Matrix }) {
  return (
    <p class="headline">
      {DIRECTIONS.map((direction, index) => {
        const { real, of } = realDifferences(matrix, direction);
        return (
          <span key={direction}>
            {index > 0 && "; "}
            {direction}: <strong>{real}</strong> of {of} differences are real
          </span>
        );
      })}
      .
    </p>
  );
}

function Tables({ matrix }: { matrix: Matrix }) {
  return (
    <>
      {DIRECTIONS.map((direction) => (
        <div key={direction}>
          <h3>Index and difference, strain {directionName(direction)}</h3>
          <DifferenceTable matrix={matrix} direction={direction} />
        </div>
      ))}
      <p class="quiet">
        Index: first-order index of each location's own contact depth for the strain at the centre, percent. Below it, the difference from the baseline in
        percentage points. ± is the estimated absolute error. A difference has an error of its own: the meshes of two designs err alike, so that a difference
        may be real although the errors of the two indices overlap. ★ marks what is real, beyond its error; grey is noise, within it; ± ? isn't known.
      </p>
      <h3>Ranking</h3>
      <RankTable matrix={matrix} />
      <p class="quiet">1 is best. ★ ↑ and ↓ are places gained and lost since the baseline, only where the errors leave no doubt about either rank.</p>
      <TermLine names={["first-order index", "real difference", "x and y", "crown", "shoulder", "sidewall"]} />
    </>
  );
}
