import type { ComponentChildren } from "preact";
import type { Loadable } from "../state.ts";
import type { Problem } from "../types.ts";

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

/** A problem in a sentence: the detail says more than the title, so it comes first when there is one. */
export function ProblemText({ problem }: { problem: Problem }) {
  if (problem.detail == null || problem.detail === "") return <p>{problem.title}</p>;
  return (
    <p>
      {problem.title.replace(/\.$/, "")}: {problem.detail}
    </p>
  );
}
