import { significant } from "../../../lib/format.ts";
import type { StudyResult } from "../../../wire.ts";

/** Points of a finished study that have no response, with their inputs and causes. */
export function FailedPoints({ result }: { result: StudyResult }) {
  if (result.failed_points.length === 0) return null;
  return (
    <section class="problem">
      <h2>Points without an answer</h2>
      <ul>
        {result.failed_points.map((point) => (
          <li key={point.ordinal}>
            point {point.ordinal} ({point.values.map((value, index) => `${result.inputs[index]?.name ?? index}=${significant(value, 4)}`).join(", ")}
            ): {point.cause}
          </li>
        ))}
      </ul>
    </section>
  );
}
