import { useState } from "preact/hooks";
import * as api from "../../api.ts";
import type { RecordingFile } from "../../lib/forces/recording-files.ts";
import { indexBars, MOST_BARS, pointsText, standing } from "../../lib/own/own-analysis.ts";
import { fileName } from "../../lib/shell/file-names.ts";
import { answerTo, type Loadable } from "../../state/loadable.ts";
import type { ModelAnalysis, ModelOutput } from "../../wire.ts";
import { FileDrop } from "../forces/file-drop.tsx";
import { Faults } from "../home/fault-list.tsx";
import { save } from "../shared/picture/picture-file.ts";
import { IndexChart } from "./index-chart.tsx";

type Kind = "inputs" | "values";
type Files = Record<Kind, RecordingFile | null>;

/** Indices of a model of the reader's own: two files dropped, bars with errors shown. */
export function OwnPage() {
  const [files, setFiles] = useState<Files>({ inputs: null, values: null });
  const [answer, setAnswer] = useState<Loadable<ModelAnalysis> | null>(null);

  async function take(kind: Kind, file: File | undefined): Promise<void> {
    if (file === undefined) return;
    const next = { ...files, [kind]: { file: file.name, text: await file.text() } };
    setFiles(next);
    if (next.inputs === null) return setAnswer(null);
    setAnswer({ status: "loading" });
    setAnswer(await answerTo(analysed(next.inputs.text, next.values?.text ?? null)));
  }

  return (
    <article>
      <h1>Your model</h1>
      <section class="panel own" aria-labelledby="own-title">
        <h2 id="own-title">Which input matters in a model of your own?</h2>
        <p>
          A file of inputs says what varies, in TOML or JSON: <code>[[inputs]]</code>, each with a <code>name</code> and a <code>distribution</code>. With it
          alone you get the points to run; with the outputs at these points, a CSV file with the header <code>id,</code> and the outputs' names, you get the
          indices. Nothing is stored.
        </p>
        <FileDrop title={nameOf(files.inputs) ?? "Drop the file of inputs here"} accept=".toml,.json" onFiles={([file]) => void take("inputs", file)} />
        <FileDrop title={nameOf(files.values) ?? "Drop the file of values here"} onFiles={([file]) => void take("values", file)} />
        {files.inputs === null && files.values !== null && <p class="quiet">The file of inputs is missing.</p>}
      </section>
      <div aria-live="polite">{answer !== null && <Answer answer={answer} model={files.inputs?.file.replace(/\.\w+$/, "") ?? "model"} />}</div>
    </article>
  );
}

/** The service's analysis. The reader of TOML is loaded by those who drop a file alone. */
async function analysed(inputs: string, values: string | null): Promise<ModelAnalysis> {
  const { readToml } = await import("../../lib/document/toml/toml-text.ts");
  const { of, fault } = readToml(inputs);
  if (fault !== null) throw new Error(`The file of inputs can't be read. ${fault.detail}`);
  return api.analyse(JSON.parse(of), values);
}

function nameOf(file: RecordingFile | null): string | null {
  return file === null ? null : `${file.file} was read: drop it again when it has changed`;
}

function Answer({ answer, model }: { answer: Loadable<ModelAnalysis>; model: string }) {
  if (answer.status === "loading") return <p class="quiet">Analysing …</p>;
  if (answer.status === "failed") return <Faults problem={answer.problem} placeOf={() => null} idle="" />;
  const analysis = answer.value;
  const savePoints = (): void => save(new Blob([pointsText(analysis)], { type: "text/csv" }), fileName(model, "points", "csv"));
  return (
    <section class="panel own" aria-labelledby="indices-title">
      <h2 id="indices-title">Indices</h2>
      <p>{standing(analysis)}</p>
      {analysis.outputs.length > 0 && analysis.advice != null && <p>{analysis.advice}</p>}
      {analysis.wanted > 0 && (
        <div class="actions">
          <button type="button" onClick={savePoints}>
            Save the points to run as CSV
          </button>
        </div>
      )}
      {analysis.outputs.map((output) => (
        <Output key={output.name} output={output} inputs={analysis.inputs} model={model} />
      ))}
    </section>
  );
}

function Output({ output, inputs, model }: { output: ModelOutput; inputs: readonly string[]; model: string }) {
  const bars = indexBars(inputs, output);
  return (
    <>
      <h3>{output.name}</h3>
      {bars.length > 0 && <IndexChart output={output.name} bars={bars} model={model} />}
      {inputs.length > MOST_BARS && bars.length > 0 && (
        <p class="quiet">
          The largest {MOST_BARS} of {inputs.length} inputs.
        </p>
      )}
      {output.reason != null && <p class="quiet">{output.reason}</p>}
    </>
  );
}
