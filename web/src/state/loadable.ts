import { problemOf, type Problem } from "../api.ts";

/** Something that is asked for: not here yet, here, or refused. */
export type Loadable<T> = { status: "loading" } | { status: "ready"; value: T } | { status: "failed"; problem: Problem };

/** What became of a question to the service. */
export async function answerTo<T>(question: Promise<T>): Promise<Exclude<Loadable<T>, { status: "loading" }>> {
  try {
    return { status: "ready", value: await question };
  } catch (error) {
    return { status: "failed", problem: problemOf(error) };
  }
}

/** Whether the service says that there is no such thing. */
export function isMissing(asked: Loadable<unknown>): asked is { status: "failed"; problem: Problem } {
  return asked.status === "failed" && asked.problem.status === 404;
}
