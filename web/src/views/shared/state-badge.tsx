import type { StudyState } from "../../types.ts";

/** The state of a study, in a word and a colour. */
export function StateBadge({ state }: { state: StudyState }) {
  return <span class={`badge badge-${state}`}>{state}</span>;
}
