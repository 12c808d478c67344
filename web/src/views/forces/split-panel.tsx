import type { ComponentChildren } from "preact";
import { MODELS } from "../../lib/forces/force-words.ts";
import { chosenBy, JUDGED, leakWords, SPLITS, splitOf } from "../../lib/forces/split-table.ts";
import { fixed } from "../../lib/format.ts";
import { type Column, heading, shown } from "../../lib/study/figures/columns.ts";
import type { ForceReport } from "../../wire.ts";
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
  const kindOf = (column: Column): string => (splitOf(column) === by ? "choosing" : "");
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
          {JUDGED.map((column, k) => (
            <th key={column.at} scope="col" rowSpan={2} class={k === 0 ? "group" : undefined} title={heading(column).title}>
              {heading(column).text}
            </th>
          ))}
        </tr>
        <tr>
          {SPLITS.map((column, k) => (
            <th key={column.at} scope="col" class={k === 0 ? `group ${kindOf(column)}` : kindOf(column)} title={heading(column).title}>
              {column.title}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {force.models.map((model, place) => (
          <tr key={`${model.model} ${model.features}`} class={place === 0 ? "chosen-row" : undefined}>
            <th scope="row" class="words">
              {MODELS[model.model]}
              {place === 0 && <span class="error">chosen</span>}
            </th>
            <td class="words">{model.model === "mean" ? "" : model.features}</td>
            {SPLITS.map((column, k) => (
              <td key={column.at} class={k === 0 ? `group ${kindOf(column)}` : kindOf(column)}>
                {shown(column, { model })}
              </td>
            ))}
            {JUDGED.map((column, k) => (
              <td key={column.at} class={k === 0 ? "group" : undefined}>
                {shown(column, { model })}
              </td>
            ))}
          </tr>
        ))}
      </tbody>
    </ScrollTable>
  );
}
