import { useMemo } from "preact/hooks";
import { comparisonExport } from "../../api.ts";
import { comparedFields } from "../../lib/document/document-differences.ts";
import type { CompareRoute } from "../../lib/route.ts";
import type { Actions } from "../../state/actions.ts";
import type { AppState, OpenComparison } from "../../state/app-state.ts";
import { isMissing } from "../../state/loadable.ts";
import type { StudyDetail } from "../../wire.ts";
import { Loaded } from "../shared/loaded.tsx";
import { ScrollTable, words } from "../shared/scroll-table.tsx";
import { Removed } from "../shell/missing.tsx";
import { AnswersPanel } from "../sweep/answers-panel.tsx";
import { ComparisonPanel } from "../sweep/comparison-panel.tsx";
import { ComparedTires } from "./tires/compared-tires.tsx";

interface Props {
  state: AppState;
  route: CompareRoute;
  actions: Actions;
}

/** Studies side by side: which answers best first, then what differs in their documents, then every index. */
export function ComparePage({ state, route, actions }: Props) {
  const open = state.openComparison;
  if (route.studies.length < 2) {
    return (
      <article>
        <h1>Compare studies</h1>
        <p>Tick two or more finished studies in the list, then follow the link below it.</p>
      </article>
    );
  }
  if (open === null) return <p class="quiet">Loading the studies …</p>;
  if (isMissing(open.details)) return <Removed what="Study" problem={open.details.problem} />;
  const baseline = route.baseline ?? (open.comparison.status === "ready" ? (open.comparison.value.baseline ?? null) : (route.studies[0] ?? null));
  return (
    <article>
      <h1>Compare {route.studies.length} studies</h1>
      <BaselineChoice route={route} baseline={baseline} names={namesOf(open)} onChoose={(to) => actions.adjust({ ...route, baseline: to })} />
      <Loaded of={open.comparison} what="the comparison" onRetry={actions.openComparison.reopen}>
        {(comparison) => (
          <AnswersPanel comparison={comparison} csv={comparisonExport({ studies: route.studies.join(",") }, baseline, "format=csv&table=designs")} />
        )}
      </Loaded>
      <Loaded of={open.details} what="the studies" onRetry={actions.openComparison.reopen}>
        {(details) => <Documents details={details} />}
      </Loaded>
      <ComparedTires key={route.studies.join()} route={route} baseline={baseline} onAdjust={actions.adjust} />
      {open.comparison.status === "ready" && (
        <ComparisonPanel comparison={open.comparison.value} shown={route.shown} onShown={(shown) => actions.adjust({ ...route, shown })} />
      )}
    </article>
  );
}

/** What all differences on the page are taken from: kept in the address. */
function BaselineChoice({
  route,
  baseline,
  names,
  onChoose,
}: {
  route: CompareRoute;
  baseline: string | null;
  names: readonly string[];
  onChoose: (study: string) => void;
}) {
  return (
    <p>
      <label>
        Baseline{" "}
        <select value={baseline ?? ""} onChange={(event) => onChoose(event.currentTarget.value)}>
          {route.studies.map((id, k) => (
            <option key={id} value={id}>
              {k + 1}: {names[k] ?? id}
            </option>
          ))}
        </select>
      </label>
    </p>
  );
}

function namesOf({ details }: OpenComparison): string[] {
  return details.status === "ready" ? details.value.map(({ name }) => name) : [];
}

function Documents({ details }: { details: StudyDetail[] }) {
  const fields = useMemo(() => comparedFields(details.map(({ document }) => document)), [details]);
  return (
    <section class="panel" aria-labelledby="documents-title">
      <h2 id="documents-title">What differs in the documents</h2>
      {fields.length === 0 ? (
        <p>Nothing but, perhaps, their names.</p>
      ) : (
        <ScrollTable
          name="Documents, field by field"
          kind="document-fields"
          isTall
          columns={[words("Field"), ...details.map(({ name }, index) => ({ text: index + 1, class: "words", title: name }))]}
        >
          <tbody>
            {fields.map(({ pointer, label, values }) => (
              <tr key={pointer}>
                <th scope="row" class="words" title={pointer}>
                  {label}
                </th>
                {values.map((value, index) => (
                  <td key={index} class="words">
                    {value}
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        </ScrollTable>
      )}
    </section>
  );
}
