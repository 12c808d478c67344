import type { Section } from "../../lib/route.ts";
import { typeset } from "../../lib/study/answer/answer-words.ts";
import type { GradedNote, StudyResult } from "../../wire.ts";

/** Where notes stand: with what they are about. */
const TOPICS: Record<Section, readonly GradedNote["about"][]> = {
  answer: [],
  tire: ["map"],
  layouts: ["layout", "signals"],
  indices: ["place", "indices"],
  trade: [],
  run: ["cost", "model"],
  sheet: [],
};

/** What bears on the figures of a section; at the end of the run what is for the record alone. */
export function SectionNotes({ result, section }: { result: StudyResult; section: Section }) {
  const notes = result.graded_notes;
  const isRecord = ({ grade }: GradedNote): boolean => grade === "for-the-record";
  const here = notes.filter((note) => !isRecord(note) && TOPICS[section].includes(note.about));
  const record = section === "run" ? notes.filter(isRecord) : [];
  return (
    <>
      {here.length > 0 && (
        <section class="notes" aria-labelledby="notes-title">
          <h2 id="notes-title">Bears on these figures</h2>
          <NoteList notes={here} />
        </section>
      )}
      {record.length > 0 && (
        <details class="panel">
          <summary>For the record: {record.length}</summary>
          <NoteList notes={record} />
        </details>
      )}
    </>
  );
}

function NoteList({ notes }: { notes: readonly GradedNote[] }) {
  return (
    <ul>
      {notes.map(({ text }) => (
        <li key={text}>{typeset(text)}</li>
      ))}
    </ul>
  );
}
