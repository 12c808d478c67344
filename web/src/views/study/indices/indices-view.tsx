import { useState } from "preact/hooks";
import { shapeOf } from "../../../lib/layouts/wheel-films.ts";
import { isPapersStudy } from "../../../lib/study/paper/paper-table.ts";
import type { SectionProps } from "../section-props.ts";
import { InputsPanel } from "./inputs/inputs-panel.tsx";
import { MatrixPanel } from "./matrix-panel.tsx";
import { RankingPanel } from "./ranking/ranking-panel.tsx";

/** The places in their order, and all indices behind it. The paper's figures stand beside them on demand, where the study is the paper's. */
export function IndicesView({ result, study }: SectionProps) {
  const [isCompared, compare] = useState(false);
  return (
    <>
      {isPapersStudy(result.inputs, shapeOf(study.document)) && (
        <p>
          <label>
            <input type="checkbox" checked={isCompared} onChange={(event) => compare(event.currentTarget.checked)} /> Compare with the paper: M-DRM and its
            Table 2
          </label>
        </p>
      )}
      <RankingPanel result={result} isCompared={isCompared} />
      <InputsPanel result={result} />
      <MatrixPanel result={result} isCompared={isCompared} />
    </>
  );
}
