import { useMemo, useState } from "preact/hooks";
import { bandRuns, forceRange } from "../../lib/forces/band-drawing.ts";
import type { LeftOutRows, SplitKind } from "../../wire.ts";
import { BandKey, BandPlot } from "./band-plot.tsx";

/** Recordings that are drawn before their reader asks for all. */
const MOST_DRAWN = 4;

const LEARNT: Record<SplitKind, string> = {
  random: "rows drawn at random, each by a model that learnt from the others, its neighbours among them",
  cycle: "each cycle by a model that didn't learn from it, but from others of its run",
  run: "each run by a model that didn't learn from it",
  time: "rows by a model that learnt from earlier ones alone",
  frequency: "cycles of each frequency by a model that learnt from those of the others",
};

interface Props {
  name: string;
  rows: LeftOutRows;
  by: SplitKind | undefined;
  files: readonly string[];
}

/** Rows that were left out: what was measured, what was estimated, and the band. */
export function LeftOutPanel({ name, rows, by, files }: Props) {
  const [isAll, setAll] = useState(false);
  const runs = useMemo(() => bandRuns(rows, files), [rows, files.join("\n")]);
  const range = useMemo(() => forceRange(runs), [runs]);
  const shown = isAll ? runs : runs.slice(0, MOST_DRAWN);
  // The page's clock ticks every second, the drawings needn't.
  const drawings = useMemo(() => shown.map((run) => <BandPlot key={run.name} run={run} force={rows.force} range={range} name={name} />), [runs, isAll, name]);
  return (
    <section class="panel" aria-labelledby="left-out-title">
      <h2 id="left-out-title">{rows.force} measured and estimated</h2>
      {by !== undefined && <p>Estimated: {LEARNT[by]}.</p>}
      <BandKey hasTruth />
      {drawings}
      {shown.length < runs.length && (
        <button type="button" onClick={() => setAll(true)}>
          Draw all {runs.length} recordings
        </button>
      )}
    </section>
  );
}
