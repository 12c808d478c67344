import { address } from "../../../api.ts";
import type { StudyResult } from "../../../wire.ts";

/** Tables that the service exports. */
const TABLES = ["indices", "locations", "trade", "films", "layouts", "candidates", "points", "signals", "forces"] as const;

/** Formats that they are exported in. */
const FILES = [
  { format: "csv", label: "CSV" },
  { format: "parquet", label: "Parquet" },
] as const;

/** The result and its tables as files, and which program and document they are from. */
export function FilesPanel({ result, hasMap, sheet }: { result: StudyResult; hasMap: boolean; sheet: string }) {
  const { id, version, spec_sha256 } = result.study;
  return (
    <section class="panel" aria-labelledby="files-title">
      <h2 id="files-title">Files</h2>
      <p class="provenance">
        {version} · document <code title={spec_sha256}>{spec_sha256.slice(0, 12)}</code> · as JSON: <a href={address(id, "result")}>the whole result</a>,{" "}
        <a href={address(id, "evaluations")}>every solved point</a>
        {FILES.map(({ format, label }) => (
          <>
            {" · "}as {label}:{" "}
            {TABLES.map((table, k) => (
              <>
                {k > 0 && ", "}
                <a href={address(id, `export?format=${format}&table=${table}`)}>{table}</a>
              </>
            ))}
          </>
        ))}
        {(result.answer?.films ?? []).length > 0 && (
          <>
            {" "}
            · to print at 1:1 and glue by: <a href={sheet}>the sheet</a>, <a href={address(id, "export?format=svg")}>its template</a>
          </>
        )}
        {hasMap && (
          <>
            {" "}
            · for ParaView: <a href={address(id, "export?format=vtu")}>the map</a>
          </>
        )}
      </p>
    </section>
  );
}
