import { beyondPlaces } from "../../../../lib/study/answer/answer-words.ts";
import type { StudyResult } from "../../../../wire.ts";
import { ShareBars } from "./share-bars.tsx";

/** The inputs that matter, of all there are, for each quantity that the study is about; nothing where the ranking says it all. */
export function InputsPanel({ result }: { result: StudyResult }) {
  const inputs = result.answer?.inputs ?? null;
  const beside = inputs?.beside ?? [];
  if (inputs === null || (beside.length === 0 && !beyondPlaces(inputs, result))) return null;
  return (
    <section class="panel" aria-labelledby="inputs-title">
      <h2 id="inputs-title">Inputs that matter</h2>
      {beyondPlaces(inputs, result) && <p>{inputs.sentence}</p>}
      {beside.map(({ quantity, sentence }) => (
        <p key={quantity}>{sentence}</p>
      ))}
      <div class="bars">
        {beyondPlaces(inputs, result) && (
          <ShareBars study={result.study.name} title={`Strain ${inputs.direction} at ${inputs.location}`} shares={inputs.shares} />
        )}
        {beside.map(({ quantity, shares }) => (
          <ShareBars key={quantity} study={result.study.name} title={`${quantity.charAt(0).toUpperCase()}${quantity.slice(1)}`} shares={shares} />
        ))}
      </div>
    </section>
  );
}
