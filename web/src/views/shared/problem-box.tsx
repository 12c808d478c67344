import type { ComponentChildren } from "preact";
import type { Problem } from "../../api.ts";

/** A problem that has just come up, and what can be done about it. */
export function ProblemBox({ problem, children }: { problem: Problem; children?: ComponentChildren }) {
  return (
    <div class="problem" role="alert">
      <ProblemText problem={problem} />
      {children}
    </div>
  );
}

/** A problem in a sentence: the detail when there is one, for the title of most is only their status in words. */
export function ProblemText({ problem }: { problem: Problem }) {
  return <p>{problemWords(problem)}</p>;
}

export function problemWords({ title, detail }: Problem): string {
  const text = detail == null || detail === "" ? title : detail;
  return text.charAt(0).toUpperCase() + text.slice(1);
}
