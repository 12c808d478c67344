import { useState } from "preact/hooks";
import { firstLines, matching, operations, type Description } from "../../lib/shell/reference/description.ts";
import type { Loadable } from "../../state/loadable.ts";
import { ProblemBox } from "../shared/problem-box.tsx";
import { Code } from "./code.tsx";
import { MarkedText } from "./marked-text.tsx";
import { OperationEntry } from "./operation-entry.tsx";

/** Everything that the service does over HTTP. */
export function ReferencePage({ described }: { described: Loadable<Description> }) {
  return (
    <div class="reference">
      <header class="masthead">
        <a class="brand" href="./">
          <span class="brand-name">strainsite</span>
          <span class="brand-line">over HTTP</span>
        </a>
        <nav aria-label="Service">
          <a href="./">Dashboard</a>
          <a href="openapi.json">OpenAPI</a>
        </nav>
      </header>
      <main id="main">
        <h1>Operations</h1>
        {described.status === "loading" && <p class="quiet">Loading the description …</p>}
        {described.status === "failed" && <ProblemBox problem={described.problem} />}
        {described.status === "ready" && <Described description={described.value} />}
      </main>
    </div>
  );
}

function Described({ description }: { description: Description }) {
  const [filter, setFilter] = useState("");
  const all = operations(description);
  const shown = matching(all, filter);
  return (
    <>
      <section aria-labelledby="first-title">
        <h2 id="first-title">From a document to its answer</h2>
        <Code name="Five lines for a shell" text={firstLines(new URL(".", location.href).href.replace(/\/$/, ""))} />
        {(description.info.description ?? "").split("\n\n").map((paragraph) => (
          <p key={paragraph}>
            <MarkedText text={paragraph} />
          </p>
        ))}
      </section>
      <section aria-labelledby="all-title">
        <h2 id="all-title">All of them</h2>
        <label class="reference-filter">
          Filter <input type="search" value={filter} placeholder="layouts, POST, export …" onInput={(event) => setFilter(event.currentTarget.value)} />
        </label>
        <p class="quiet" role="status">
          {shown.length} of {all.length} operations
        </p>
        {shown.map((operation) => (
          <OperationEntry key={operation.id} operation={operation} />
        ))}
      </section>
      <section aria-labelledby="documents-title">
        <h2 id="documents-title">Documents</h2>
        <p class="quiet">What is sent and answered, as JSON schemas.</p>
        {Object.entries(description.components.schemas).map(([name, schema]) => (
          <details key={name} id={name} class="reference-entry">
            <summary>{name}</summary>
            <Code name={`Schema of ${name}`} text={JSON.stringify(schema, null, 2)} />
          </details>
        ))}
      </section>
    </>
  );
}
