import type { ComponentChildren } from "preact";
import type { ForceReport } from "../../wire.ts";
import { chosenBy, leakWords, splitRows, SPLITS } from "../../lib/forces/split-table.ts";
import { fixed } from "../../lib/format.ts";
import { ScrollTable } from "../shared/scroll-table.tsx";

/** Models of a force side by side on every split. */
export function SplitPanel({ force, choice }: { force: ForceReport; choice: ComponentChildren }) {
  const leak = leakWords(force);
  return (
    <section class="panel" aria-labelledby="splits-title">
      <h2 id="splits-title">Models of {force.force} on rows left out</h2>
      {choice}
      {leak !== null && <p>{leak}</p>}
      <SplitTable force={force} />
      <p class="quiet">
        RMSE on rows that a model didn't learn from: a fifth of the rows drawn at random, whose neighbours it did learn from; whole cycles; whole runs; rows
        later than those that it learnt from; cycles of a frequency of their own. The shaded split chooses the model; NRMSE (RMSE over the range of the force),
        coverage and width of the 95 % intervals are of that one. Leak: RMSE of the strictest split over that of random rows.
        {force.rolled_r2 != null && ` With forces rolled against the signals, which is chance, R² is ${fixed(force.rolled_r2, 2)}.`}
      </p>
    </section>
  );
}

function SplitTable({ force }: { force: ForceReport }) {
  const by = chosenBy(force);
  const kindOf = (split: string): string => (split === by ? "choosing" : "");
  return (
    <ScrollTable name={`Models of ${force.force}`} kind="splits">
      <thead>
        <tr>
          <th scope="col" class="words" rowSpan={2}>
            Model
          </th>
          <th scope="col" class="words" rowSpan={2}>
            Features
          </th>
          <th scope="colgroup" colSpan={SPLITS.length} class="group">
            RMSE, N, left out:
          </th>
          <th scope="col" rowSpan={2} class="group">
            Leak
          </th>
          <th scope="col" rowSpan={2}>
            NRMSE %
          </th>
          <th scope="col" rowSpan={2}>
            Mean's NRMSE %
          </th>
          <th scope="col" rowSpan={2}>
            Covered %
          </th>
          <th scope="col" rowSpan={2}>
            Width N
          </th>
        </tr>
        <tr>
          {SPLITS.map(({ split, title }, k) => (
            <th key={split} scope="col" class={k === 0 ? `group ${kindOf(split)}` : kindOf(split)}>
              {title}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {splitRows(force).map((row) => (
          <tr key={row.key} class={row.isChosen ? "chosen-row" : undefined}>
            <th scope="row" class="words">
              {row.model}
              {row.isChosen && <span class="error">chosen</span>}
            </th>
            <td class="words">{row.features}</td>
            {row.errors.map((error, k) => (
              <td key={SPLITS[k]?.split} class={k === 0 ? `group ${kindOf(SPLITS[k]?.split ?? "")}` : kindOf(SPLITS[k]?.split ?? "")}>
                {error}
              </td>
            ))}
            <td class="group">{row.leak}</td>
            <td>{row.nrmse}</td>
            <td>{row.mean_nrmse}</td>
            <td>{row.coverage}</td>
            <td>{row.width}</td>
          </tr>
        ))}
      </tbody>
    </ScrollTable>
  );
}
