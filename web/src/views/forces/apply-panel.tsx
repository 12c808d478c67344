import { useMemo, useState } from "preact/hooks";
import * as api from "../../api.ts";
import { forceRange } from "../../lib/forces/band-drawing.ts";
import { readEstimates, type Estimates } from "../../lib/forces/estimates-text.ts";
import { recordingOf } from "../../lib/forces/recording-files.ts";
import { integer, percent } from "../../lib/format.ts";
import { fileName } from "../../lib/shell/file-names.ts";
import { answerTo, type Loadable } from "../../state/loadable.ts";
import { Facts } from "../shared/facts.tsx";
import { Faults } from "../home/fault-list.tsx";
import { save } from "../shared/picture/picture-file.ts";
import { BandKey, BandPlot } from "./band-plot.tsx";
import { FileDrop } from "./file-drop.tsx";

interface Applied {
  file: string;
  answer: Loadable<string>;
}

/** Forces of a recording that is dropped: drawn, and to be saved as CSV. */
export function ApplyPanel({ id, name }: { id: string; name: string }) {
  const [applied, setApplied] = useState<Applied | null>(null);

  async function apply(file: File): Promise<void> {
    setApplied({ file: file.name, answer: { status: "loading" } });
    const read = await answerTo(recordingOf(file));
    const answer = read.status === "ready" ? await answerTo(api.applyEstimator(id, read.value)) : read;
    setApplied((now) => (now?.file === file.name ? { file: file.name, answer } : now));
  }

  return (
    <section class="panel applied" aria-labelledby="apply-title">
      <h2 id="apply-title">Forces of another recording</h2>
      <p class="quiet">A CSV file with the same time and signals; forces aren't needed. Nothing of it is stored.</p>
      <FileDrop title="Drop a CSV file here" onFiles={([file]) => file !== undefined && void apply(file)} />
      <div aria-live="polite">{applied !== null && <Answer applied={applied} name={name} />}</div>
    </section>
  );
}

function Answer({ applied: { file, answer }, name }: { applied: Applied; name: string }) {
  if (answer.status === "loading") return <p class="quiet">Estimating {file} …</p>;
  if (answer.status === "failed") return <Faults problem={answer.problem} placeOf={() => null} idle="" />;
  return <Forces file={file} text={answer.value} name={name} />;
}

function Forces({ file, text, name }: { file: string; text: string; name: string }) {
  const estimates = useMemo(() => readEstimates(text), [text]);
  const saveText = (): void => save(new Blob([text], { type: "text/csv" }), fileName(file.replace(/\.csv$/i, ""), "forces", "csv"));
  const drawings = useMemo(() => estimates?.forces.map((force) => <Drawn key={force.force} of={force} file={file} name={name} />), [estimates]);
  return (
    <>
      {estimates !== null && <Facts facts={factsOf(file, estimates)} />}
      <div class="actions">
        <button type="button" onClick={saveText}>
          Save forces as CSV
        </button>
      </div>
      <BandKey hasTruth={false} />
      {drawings}
    </>
  );
}

function Drawn({ of: { force, rows }, file, name }: { of: Estimates["forces"][number]; file: string; name: string }) {
  const run = { name: `${force}, ${file}`, rows };
  return <BandPlot run={run} force={force} range={forceRange([run])} name={name} />;
}

function factsOf(file: string, { rows, outside }: Estimates): [string, string][] {
  const beyond = rows === 0 ? 0 : outside / rows;
  return [
    ["Recording", file],
    ["Rows", integer(rows)],
    ["With a signal beyond those learnt from", outside === 0 ? "none" : `${integer(outside)} (${percent(beyond, 1)} %): what is promised doesn't hold there`],
  ];
}
