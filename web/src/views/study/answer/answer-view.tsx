import { typeset, unrankedWords } from "../../../lib/study/answer/answer-words.ts";
import { formatRoute } from "../../../lib/route.ts";
import type { SectionProps } from "../section-props.ts";
import { AnswerPicture } from "./answer-picture.tsx";
import { AnswerText } from "./answer-text.tsx";
import { TradePlot } from "./trade-plot.tsx";

/** Where the films go, how sure that is, and what could overturn it. */
export function AnswerView({ result, study, route }: SectionProps) {
  const answer = result.answer ?? null;
  return (
    <section class="panel answer" aria-labelledby="answer-title">
      <h2 id="answer-title" class="hidden">
        Answer
      </h2>
      {answer === null ? (
        <div class="answer-text">
          <p class="answer-sentence">{unrankedWords(result)}</p>
          <p>
            <a href={formatRoute({ ...route, section: "indices" })}>All indices</a>
          </p>
        </div>
      ) : (
        <AnswerText
          answer={answer}
          notes={notesOf(result, answer.left_out?.sentence)}
          places={result.locations.length}
          sheet={formatRoute({ ...route, section: "sheet" })}
        />
      )}
      {answer?.trade != null && <TradePlot trade={answer.trade} />}
      <AnswerPicture result={result} study={study} answer={answer} />
    </section>
  );
}

/** Notes that change the answer; what is left out has its own line. */
function notesOf(result: SectionProps["result"], leftOut: string | undefined): string[] {
  const changing = result.graded_notes.filter(({ grade, text }) => grade === "changes-answer" && text !== leftOut);
  return changing.map(({ text }) => typeset(text));
}
