import { residualShare, solveWords } from "../../../lib/study/progress/solve-words.ts";
import type { LiveSolve } from "../../../wire.ts";

/** The solves under way that take longer than a moment, each with its residual on the way down. */
export function CurrentSolves({ solves }: { solves: readonly LiveSolve[] }) {
  return (
    <ul class="current-solves" aria-label="Solves under way">
      {solves.map((solve) => (
        <li key={solve.ordinal}>
          <meter min={0} max={1} value={residualShare(solve)} aria-label={`Residual of point ${solve.ordinal}`} /> {solveWords(solve)}
        </li>
      ))}
    </ul>
  );
}
