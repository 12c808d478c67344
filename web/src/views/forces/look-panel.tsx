import { useState } from "preact/hooks";
import { significant } from "../../lib/format.ts";
import { figures, lookSentence, recordingFacts, suspicions, takenWords } from "../../lib/forces/look-words.ts";
import type { ColumnLook, Look, RecordingLook } from "../../wire.ts";
import type { Loadable } from "../../state/loadable.ts";
import { Faults } from "../home/fault-list.tsx";
import { Facts } from "../shared/facts.tsx";
import { ScrollTable, words } from "../shared/scroll-table.tsx";
import { ColumnPicture } from "./column-picture.tsx";

/** Columns that are shown before their reader asks for all. */
const MOST_SHOWN = 60;
const HEADS = [words("Column"), words("Taken for"), words("Over time"), "Least", "Greatest", "Empty", "Noise", "Unloaded", "Drift"];

/** What the columns of the recordings are taken for, before anything is learnt. */
export function LookPanel({ look }: { look: Loadable<Look> }) {
  if (look.status === "loading") return <p class="quiet">Looking at the columns …</p>;
  if (look.status === "failed") return <Faults problem={look.problem} placeOf={() => null} idle="" />;
  const { recordings, faults, refusals } = look.value;
  return (
    <div class="look">
      <h3>What the columns are taken for</h3>
      <p>{lookSentence(look.value)}</p>
      <Sentences kind="problem" sentences={faults.map(({ detail }) => detail)} />
      <Sentences kind="notes" sentences={refusals.map(({ detail }) => detail)} />
      {recordings.map((recording, k) => (
        <details key={recording.file} open={k === 0 || suspicions(recording).length > 0}>
          <summary>{recording.file}</summary>
          <OneRecording recording={recording} />
        </details>
      ))}
      {recordings.length > 0 && (
        <p class="quiet">
          Noise is the median size of the differences between neighbours, over √2 · 0.6745; unloaded the median where no force acts, and drift how far it moves
          from the first third of such rows to the last. Forces are in newtons, times in seconds. In the pictures gaps are shaded, and rings mark samples that
          stand alone.
        </p>
      )}
    </div>
  );
}

function OneRecording({ recording }: { recording: RecordingLook }) {
  const [isAll, setAll] = useState(false);
  const { file, columns, notes } = recording;
  const shown = isAll ? columns : columns.slice(0, MOST_SHOWN);
  return (
    <>
      <Facts facts={recordingFacts(recording)} />
      <Sentences kind="notes" sentences={suspicions(recording)} />
      <ScrollTable name={`Columns of ${file}`} kind="looks" columns={HEADS}>
        <tbody>
          {shown.map((column) => (
            <Row key={column.column} recording={recording} column={column} />
          ))}
        </tbody>
      </ScrollTable>
      {shown.length < columns.length && (
        <button type="button" onClick={() => setAll(true)}>
          Show all {columns.length} columns
        </button>
      )}
      {notes.map((note) => (
        <p key={note} class="quiet">
          {note.charAt(0).toUpperCase() + note.slice(1)}.
        </p>
      ))}
    </>
  );
}

function Row({ recording, column }: { recording: RecordingLook; column: ColumnLook }) {
  const series = recording.series?.columns.find((each) => each.column === column.column);
  return (
    <tr>
      <th scope="row" class="words">
        {column.column}
      </th>
      <td class="words">
        {takenWords(column)}
        {column.suspicions.length > 0 && <span class="flag"> suspect</span>}
      </td>
      <td class="words">{series !== undefined && <ColumnPicture recording={recording} column={column} series={series} />}</td>
      <td>{significant(column.least, 4)}</td>
      <td>{significant(column.greatest, 4)}</td>
      {figures(column).map((figure, k) => (
        <td key={k}>{figure}</td>
      ))}
    </tr>
  );
}

function Sentences({ kind, sentences }: { kind: "problem" | "notes"; sentences: readonly string[] }) {
  if (sentences.length === 0) return null;
  return (
    <div class={kind}>
      <ul>
        {sentences.map((sentence) => (
          <li key={sentence}>{sentence}</li>
        ))}
      </ul>
    </div>
  );
}
