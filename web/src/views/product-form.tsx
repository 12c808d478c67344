import { fixed } from "../lib/format.ts";
import { centreOutput, methodName, paperGap } from "../lib/result.ts";
import type { Direction, StudyResult } from "../types.ts";

/** Says plainly when M-DRM's product form doesn't hold for the centre's strain, and what that means for the paper's column. */
export function ProductFormNotice({ result, direction }: { result: StudyResult; direction: Direction }) {
  const output = centreOutput(result, direction);
  if (output?.status !== "product-form-broken") return null;
  const gap = paperGap(result, direction);
  // Nearer than half of the valid column's distance counts as the same column.
  const reproduces = gap !== null && gap.mdrm < gap.valid / 2;
  return (
    <div class="notice">
      <p>
        <strong>M-DRM is wrong for the {direction} strain of this study.</strong> Its product form is broken
        {output.reason == null ? "" : ` (${output.reason})`}, so the {methodName(output.method)} took over.{" "}
        {gap !== null && reproduces && (
          <>
            M-DRM's own column comes within {fixed(gap.mdrm, 1)} percentage points of the paper's {direction} column, the
            valid indices differ from it by up to {fixed(gap.valid, 1)}:{" "}
            <strong>the paper's {direction} column is what M-DRM gives where it doesn't hold.</strong>
          </>
        )}
        {gap !== null && !reproduces && (
          <>
            M-DRM's own column stands beside for comparison; it differs from the paper's by up to {fixed(gap.mdrm, 1)}{" "}
            percentage points.
          </>
        )}
      </p>
    </div>
  );
}
