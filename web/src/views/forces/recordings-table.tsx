import type { RecordingFigures } from "../../wire.ts";
import { integer, significant } from "../../lib/format.ts";
import { ScrollTable, words } from "../shared/scroll-table.tsx";

/** What was learnt from. */
export function RecordingsTable({ recordings }: { recordings: readonly RecordingFigures[] }) {
  return (
    <section class="panel" aria-labelledby="recordings-title">
      <h2 id="recordings-title">Recordings</h2>
      <ScrollTable name="Recordings" kind="recordings" columns={[words("File"), "Rows", "With forces", "Cycles", "Rows a second", words("SHA-256")]}>
        <tbody>
          {recordings.map(({ file, rows, labelled, cycles, rate_hz, sha256 }, k) => (
            <tr key={k}>
              <th scope="row" class="words">
                {file}
              </th>
              <td>{integer(rows)}</td>
              <td>{integer(labelled)}</td>
              <td>{integer(cycles)}</td>
              <td>{significant(rate_hz, 3)}</td>
              <td class="words">
                <code title={sha256}>{sha256.slice(0, 12)}</code>
              </td>
            </tr>
          ))}
        </tbody>
      </ScrollTable>
    </section>
  );
}
