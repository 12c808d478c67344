import type { StudyDetail } from "../../../wire.ts";

/** What was asked for, whatever became of it. */
export function DocumentPanel({ study }: { study: StudyDetail }) {
  return (
    <section class="panel" aria-labelledby="document-title">
      <h2 id="document-title">Document</h2>
      <details>
        <summary>The document as the service reads it, every default filled in</summary>
        <pre class="document-text" tabIndex={0}>
          {JSON.stringify(study.document, null, 2)}
        </pre>
      </details>
    </section>
  );
}
