import type { ComponentChildren } from "preact";
import type { Loadable } from "../../state/loadable.ts";
import { ProblemBox } from "./problem-box.tsx";

/** Shows what is here, or that it is on its way, or why it isn't and a button to ask again. */
export function Loaded<T>(props: { of: Loadable<T>; what: string; onRetry: () => void; children: (value: T) => ComponentChildren }) {
  const { of, what, onRetry, children } = props;
  if (of.status === "ready") return <>{children(of.value)}</>;
  if (of.status === "loading") {
    return (
      <p class="quiet" role="status">
        Loading {what} …
      </p>
    );
  }
  return (
    <ProblemBox problem={of.problem}>
      <button type="button" onClick={onRetry}>
        Ask again
      </button>
    </ProblemBox>
  );
}
