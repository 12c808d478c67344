import type { ComponentChildren } from "preact";
import {
  besideWords,
  firstOf,
  inputWords,
  layoutStanding,
  leadOf,
  leftOutWords,
  placeWords,
  surerWords,
  typeset,
} from "../../../lib/study/answer/answer-words.ts";
import { Term } from "../../shared/term/term.tsx";
import { VerdictBadge } from "./verdict-badge.tsx";
import type { Answer } from "../../../wire.ts";

/** The answer first, then how sure it is, then what it leaves out and, of one that isn't certain, what a surer one costs; the figures behind it folded. The layout has a line of its own where the verdict is the place's, and inputs where there are more than the depths below the places. */
export function AnswerText({ answer, notes, places, sheet }: { answer: Answer; notes: string[]; places: number; sheet: string }) {
  const { verdict, place, layout, inputs, rests_on, left_out, surer } = answer;
  return (
    <div class="answer-text">
      <p class="answer-sentence">{firstOf(answer.sentence)}</p>
      <p class="answer-sure">
        <Term of={verdict}>
          <VerdictBadge verdict={verdict} />
        </Term>{" "}
        {leadOf(answer.reason)}
      </p>
      <dl class="answer-facts">
        {place != null && (
          <Fact name="Place">
            {placeWords(place)} <VerdictBadge verdict={place.verdict} />
          </Fact>
        )}
        {layout != null && layout.reason !== answer.reason && (
          <Fact name="Layout">
            {layoutStanding(layout)} <VerdictBadge verdict={layout.verdict} />
          </Fact>
        )}
        {inputs != null && inputs.sentence !== answer.sentence && inputs.shares.length > places && <Fact name="Inputs">{inputWords(inputs)}</Fact>}
        {(inputs?.beside ?? []).map((beside) => (
          <Fact key={beside.quantity} name={beside.unit === "V" ? "Volts" : "All inputs"}>
            {besideWords(beside)}
          </Fact>
        ))}
        {rests_on != null && rests_on.brief !== "" && <Fact name="Rests on">{typeset(rests_on.brief)}</Fact>}
        {left_out != null && <Fact name="Left out">{leftOutWords(left_out)}</Fact>}
        {surer != null && verdict !== "certain" && <Fact name="Surer">{surerWords(surer)}</Fact>}
      </dl>
      <Why answer={answer} notes={notes} />
      {(answer.films ?? []).length > 0 && (
        <a class="answer-sheet" href={sheet}>
          Sheet to glue by
        </a>
      )}
    </div>
  );
}

function Fact({ name, children }: { name: string; children: ComponentChildren }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd>{children}</dd>
    </div>
  );
}

/** All sentences in full, and the notes that bear on the answer. */
function Why({ answer: { sentence, place, layout, trade, inputs, rests_on, left_out, surer }, notes }: { answer: Answer; notes: string[] }) {
  const beside = (inputs?.beside ?? []).map(({ sentence }) => sentence);
  const whole = [sentence, trade?.menu, place?.reason, layout?.reason, ...beside, rests_on?.sentence, left_out?.sentence, surer?.sentence].filter(
    (sentence) => sentence !== undefined,
  );
  return (
    <details>
      <summary>Why{notes.length > 0 && `, ${notes.length} ${notes.length === 1 ? "note" : "notes"}`}</summary>
      {whole.map((sentence) => (
        <p key={sentence}>{typeset(sentence)}</p>
      ))}
      {notes.length > 0 && (
        <ul>
          {notes.map((note) => (
            <li key={note}>{note}</li>
          ))}
        </ul>
      )}
    </details>
  );
}
