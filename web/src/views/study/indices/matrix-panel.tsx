import { useState } from "preact/hooks";
import { address } from "../../../api.ts";
import { css, sequential } from "../../../lib/chart/colour.ts";
import { fixed, microstrain, percent } from "../../../lib/format.ts";
import { methodName, statusName } from "../../../lib/study/output-words.ts";
import type { Output, StudyResult } from "../../../wire.ts";
import { RadioChoice, type Option } from "../../shared/radio-choice.tsx";
import { ScrollTable, words } from "../../shared/scroll-table.tsx";

type Kind = "first_order" | "total";

const KINDS: readonly Option<Kind>[] = [
  { value: "first_order", label: "First-order" },
  { value: "total", label: "Total" },
];

/** Every output by every input. */
export function MatrixPanel({ result, isCompared }: { result: StudyResult; isCompared: boolean }) {
  const [kind, setKind] = useState<Kind>("first_order");
  return (
    <details class="panel">
      <summary>
        <h2 class="summary-title">All outputs by all inputs</h2>
      </summary>
      <RadioChoice name="matrix-kind" legend="Kind of index" isLegendHidden options={KINDS} chosen={kind} onChoose={setKind} />
      <ScrollTable
        name="Indices of all outputs"
        kind="matrix"
        csv={address(result.study.id, "export?format=csv&table=indices")}
        columns={["Strain", ...result.inputs.map(({ name, vary }) => ({ text: name, title: vary })), "Error ±", "Mean µε", "Std µε", words("Method, status")]}
      >
        <tbody>
          {result.outputs.map((output) => (
            <Rows key={output.location + output.direction} output={output} kind={kind} inputs={result.inputs.length} isCompared={isCompared} />
          ))}
        </tbody>
      </ScrollTable>
      <p class="quiet">
        {kind === "first_order" ? "First-order" : "Total"} indices, percent of the output's variance. Mean and standard deviation of the strain in microstrain
        (µε, 10⁻⁶), relative to the inflated state. Error: of the first-order indices, percentage points.
      </p>
    </details>
  );
}

function Rows({ output, kind, inputs, isCompared }: { output: Output; kind: Kind; inputs: number; isCompared: boolean }) {
  const mdrm = isCompared && kind === "first_order" ? (output.mdrm_first_order ?? null) : null;
  return (
    <>
      <tr>
        <th scope="row">
          {output.location} {output.direction}
        </th>
        {Array.from({ length: inputs }, (_, index) => (
          <IndexCell key={index} share={output[kind]?.[index] ?? null} />
        ))}
        <td title={errorParts(output)}>{output.error.total == null ? "?" : percent(output.error.total)}</td>
        <td>{microstrain(output.mean)}</td>
        <td>{microstrain(output.std)}</td>
        <td class="words" title={output.reason ?? undefined}>
          {methodName(output.method)}; {statusName(output.status)}
        </td>
      </tr>
      {mdrm !== null && (
        <tr class="aside">
          <th scope="row">M-DRM</th>
          {mdrm.map((share, index) => (
            <td key={index}>{percent(share, 1)}</td>
          ))}
          <td colSpan={3} />
          <td class="words">not valid here</td>
        </tr>
      )}
    </>
  );
}

function IndexCell({ share }: { share: number | null }) {
  if (share === null) return <td>{percent(share, 1)}</td>;
  // Dark text from the lightness at which both colours of text are about as readable.
  const dark = share > 0.55;
  return (
    <td class={dark ? "tinted dark-text" : "tinted light-text"} style={{ backgroundColor: css(sequential(share)) }}>
      {percent(share, 1)}
    </td>
  );
}

function errorParts({ error }: Output): string {
  const part = (name: string, value: number | null | undefined): string => `${name} ${value == null ? "?" : fixed(100 * value, 2)}`;
  const parts = [part("mesh", error.mesh), part("quadrature", error.quadrature), part("decomposition", error.decomposition)];
  return parts.join(", ") + (error.reason == null ? "" : `; ${error.reason}`);
}
