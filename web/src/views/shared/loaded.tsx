import type { ComponentChildren } from "preact";
import type { Loadable } from "../../state/app-state.ts";
import type { Problem } from "../../types.ts";

/** Shows what is here, or that it is on its way, or why it isn't and a button to ask again. */
export function Loaded<T>(props: {
  of: Loadable<T>;
  what: string;
  onRetry: () => void;
  children: (value: T) => ComponentChildren;
}) {
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
    <div class="problem" role="alert">
      <ProblemText problem={of.problem} />
      <button type="button" onClick={onRetry}>
        Ask again
      </button>
    </div>
  );
}

/** A problem in a sentence: the detail when there is one, for the title of most is only their status in words. */
export function ProblemText({ problem }: { problem: Problem }) {
  const text = problem.detail == null || problem.detail === "" ? problem.title : problem.detail;
  return <p>{text.charAt(0).toUpperCase() + text.slice(1)}</p>;
}
