import type { Direction } from "../../../../lib/direction.ts";
import { fixed } from "../../../../lib/format.ts";
import { methodName } from "../../../../lib/study/output-words.ts";
import { centreOutput, mdrmGap, paperGap } from "../../../../lib/study/result-picks.ts";
import type { Output, StudyResult } from "../../../../wire.ts";

/** Says plainly when M-DRM's product form doesn't hold for the centre's strain, and what that means for the paper's column. */
export function ProductFormNotice({ result, direction }: { result: StudyResult; direction: Direction }) {
  const output = centreOutput(result, direction);
  if (output?.status !== "product-form-broken") return null;
  const gap = mdrmGap(result, direction);
  return (
    <div class="notice">
      <p>
        <Verdict direction={direction} gap={gap} /> <Cause output={output} />{" "}
        {gap !== null && `The two columns differ by up to ${fixed(gap.points, 1)} percentage points. `}
        <PaperSentence result={result} direction={direction} />
      </p>
    </div>
  );
}

function Verdict({ direction, gap }: { direction: Direction; gap: ReturnType<typeof mdrmGap> }) {
  if (gap?.covered) {
    return <strong>M-DRM doesn't hold for the {direction} strain of this study, but the error bars cover its figures.</strong>;
  }
  return <strong>M-DRM is wrong for the {direction} strain of this study.</strong>;
}

function Cause({ output }: { output: Output }) {
  const reason = output.reason == null ? "" : ` (${output.reason})`;
  return (
    <>
      Its product form is broken{reason}, so the {methodName(output.method)} took over.
    </>
  );
}

function PaperSentence({ result, direction }: { result: StudyResult; direction: Direction }) {
  const gap = paperGap(result, direction);
  // Nearer than half of the valid column's distance counts as the same column.
  if (gap === null || gap.mdrm >= gap.valid / 2) return null;
  return (
    <>
      M-DRM's own column comes within {fixed(gap.mdrm, 1)} points of the paper's {direction} column, the valid one differs from it by up to{" "}
      {fixed(gap.valid, 1)}: <strong>the paper's {direction} column is what M-DRM gives where it doesn't hold.</strong>
    </>
  );
}
