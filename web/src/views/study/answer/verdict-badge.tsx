import { TERMS } from "../../../lib/shell/terms.ts";
import type { Certainty } from "../../../wire.ts";

/** How sure something is, in a word; the style puts a sign before it. */
export function VerdictBadge({ verdict }: { verdict: Certainty }) {
  return (
    <span class={`verdict verdict-${verdict}`} title={TERMS[verdict]}>
      {verdict}
    </span>
  );
}
