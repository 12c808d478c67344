import type { ComponentChildren } from "preact";
import type { Problem } from "../../api.ts";
import { formatRoute, homeRoute } from "../../lib/route.ts";
import { problemWords } from "../shared/problem-box.tsx";

/** What isn't there, why, and the ways on: what the kind adds, a new study, and the lists. */
export function Missing({ what, why, children }: { what: string; why: string; children?: ComponentChildren }) {
  return (
    <article>
      <h1>{what} not found</h1>
      <p role="alert">{why}</p>
      <p>
        {children}
        <a href={formatRoute(homeRoute())}>New study</a> or{" "}
        <button type="button" class="link" onClick={() => document.getElementById("lists")?.focus()}>
          studies and sweeps that are here
        </button>
      </p>
    </article>
  );
}

/** What the service says that it doesn't have. */
export function Removed({ what, problem, children }: { what: string; problem: Problem; children?: ComponentChildren }) {
  return (
    <Missing what={what} why={`${problemWords(problem)}. It was removed, or the link to it isn't whole.`}>
      {children}
    </Missing>
  );
}
