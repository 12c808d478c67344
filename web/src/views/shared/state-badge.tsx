import type { State } from "../../wire.ts";

/** The state of a study, in a word and a colour. */
export function StateBadge({ state }: { state: State }) {
  return <span class={`badge badge-${state}`}>{state}</span>;
}
