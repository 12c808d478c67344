import { fixed } from "../../../lib/format.ts";
import { type PublishedLine, publishedLines } from "../../../lib/layouts/published-lines.ts";
import type { PublishedRow, PublishedTables } from "../../../wire.ts";
import { ScrollTable } from "../../shared/scroll-table.tsx";

/** The published study's tables beside the rig's. */
export function PublishedPanel({ published }: { published: PublishedTables }) {
  const contradictions = published.rows.filter((row) => row.printed.contradiction != null);
  return (
    <details>
      <summary>The published study's tables beside the rig's, by layout {published.layout_rank}</summary>
      <ScrollTable name="Published tables and the rig's" isTall>
        <thead>
          <tr>
            <th scope="col">Table</th>
            <th scope="col" class="words">
              Gait
            </th>
            <th scope="col" class="words">
              Model
            </th>
            {["Fx", "Fy", "Fz"].flatMap((force) => [
              <th scope="col" key={`${force} printed`}>
                {force} printed %
              </th>,
              <th scope="col" key={`${force} rig`}>
                rig %
              </th>,
              <th scope="col" key={`${force} mean`}>
                mean %
              </th>,
            ])}
          </tr>
        </thead>
        <tbody>
          {publishedLines(published.rows).map((line) => (
            <Line key={line.key} line={line} />
          ))}
        </tbody>
      </ScrollTable>
      <p class="quiet">NRMSE. Rig: the virtual rig under the same conditions. Mean: what the mean force would reach there. *: contradicts other printed figures.</p>
      {contradictions.length > 0 && (
        <ul>
          {contradictions.map((row) => (
            <li key={`${row.table} ${row.gait} ${row.model} ${row.axis} ${row.by}`}>
              Table {row.table}, {row.gait}, {row.model}, {row.axis}: {row.printed.contradiction?.detail}
            </li>
          ))}
        </ul>
      )}
      <TimeConstants published={published} />
      <ul>
        {published.assumed.map((sentence) => (
          <li key={sentence}>{sentence}</li>
        ))}
      </ul>
    </details>
  );
}

function Line({ line }: { line: PublishedLine }) {
  return (
    <tr>
      <td>{line.table}</td>
      <td class="words">{line.gait}</td>
      <th scope="row" class="words">
        {line.model}
      </th>
      {line.forces.flatMap((row, axis) => [
        <td key={`printed ${axis}`}>{printed(row)}</td>,
        <td key={`rig ${axis}`}>{fixed(row?.rig?.nrmse_percent, 1)}</td>,
        <td key={`mean ${axis}`}>{fixed(row?.rig?.mean_nrmse_percent, 1)}</td>,
      ])}
    </tr>
  );
}

function printed(row: PublishedRow | undefined): string {
  const mark = row?.printed.contradiction == null ? "" : "*";
  return fixed(row?.printed.nrmse_percent, 2) + mark;
}

function TimeConstants({ published }: { published: PublishedTables }) {
  const told = published.time_constants.filter((row) => row.axis === "fz");
  if (told.length === 0) return null;
  const words = told.map((row) => `${fixed(row.error.nrmse_percent, 1)} % (R² ${fixed(row.error.r2, 2)}) by ${row.time_constant_s} s`);
  return <p>Fz of that layout on runs with other films, by its circuit's time constant: {words.join(", ")}.</p>;
}
