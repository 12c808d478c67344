import { across, frameOf } from "../../../../lib/chart/frame.ts";
import { linearTicks, percents, places, placeTicks, type Linear } from "../../../../lib/chart/scales.ts";
import { directionName, type Direction } from "../../../../lib/direction.ts";
import { fixed, MISSING } from "../../../../lib/format.ts";
import { paperPercent } from "../../../../lib/study/paper/paper-table.ts";
import { bars, productFormBroken, type Bar } from "../../../../lib/study/result-picks.ts";
import type { StudyResult } from "../../../../wire.ts";
import { Axis } from "../../../shared/chart/axis.tsx";
import { Chart } from "../../../shared/chart/chart.tsx";
import { ErrorBar } from "../../../shared/chart/marks.tsx";
import { KeyEntry } from "../../../shared/chart/key.tsx";
import { Figure } from "../../../shared/picture/figure.tsx";

const [WIDTH, ROW] = [460, 30];
const BESIDE = { left: 34, right: 96, top: 8, bottom: 36 };
/** Share of a row that is free. */
const GAP = 7 / 15;

/** Indices of one direction as bars with error bars; M-DRM's and the paper's figures are marked where they are compared. */
export function Bars({ result, direction, isCompared }: { result: StudyResult; direction: Direction; isCompared: boolean }) {
  const rows = bars(result, direction);
  const isBroken = productFormBroken(result, direction);
  const frame = frameOf(WIDTH, BESIDE.top + ROW * rows.length + BESIDE.bottom, BESIDE);
  const x = percents(across(frame));
  const names = rows.map((row) => row.name);
  const y = places(names, [frame.top, frame.bottom], GAP);
  const title = `First-order indices, strain ${directionName(direction)}, percent`;
  const words = rows.map((row) => `${row.name} ${fixed(row.percent, 1)}`).join(", ");
  return (
    <Figure study={result.study.name} name={`indices-${direction}`}>
      <figcaption>Strain {directionName(direction)}</figcaption>
      <Chart frame={frame} label={`${title}: ${words}`}>
        <Axis side="bottom" frame={frame} {...linearTicks(x, 4)} title="percent of the centre's variance" />
        <Axis class="bar-names" side="left" frame={frame} {...placeTicks(y)} lines="none" />
        {rows.map((row) => (
          <g key={row.name} transform={`translate(0 ${placeTicks(y).at(row.name)})`}>
            <Measured row={row} x={x} breadth={y.bandwidth()} />
            {isCompared && <Compared row={row} x={x} paper={paperPercent(row.name, direction)} isBroken={isBroken} />}
          </g>
        ))}
      </Chart>
    </Figure>
  );
}

/** A row about its middle: the bar, its error, and both as figures. */
function Measured({ row: { percent, error }, x, breadth }: { row: Bar; x: Linear; breadth: number }) {
  const reach = percent === null ? "" : ` ± ${error === null ? MISSING : fixed(error, 1)}`;
  return (
    <>
      {percent !== null && <rect class="bar" x={x(0)} y={-breadth / 2} width={x(percent) - x(0)} height={breadth} />}
      {percent !== null && error !== null && <ErrorBar class="error-bar" isLying at={0} ends={[x(percent - error), x(percent + error)]} cap={5} />}
      <text class="bar-value" x={WIDTH - 4} y={4} text-anchor="end">
        {fixed(percent, 1)}
        {reach}
      </text>
    </>
  );
}

function Compared({ row: { mdrm }, x, paper, isBroken }: { row: Bar; x: Linear; paper: number | null; isBroken: boolean }) {
  return (
    <>
      {mdrm !== null && isBroken && <circle class="mdrm-mark" cx={x(mdrm)} r={4.5} />}
      {paper !== null && <Diamond cx={x(paper)} cy={0} />}
    </>
  );
}

function Diamond({ cx, cy }: { cx: number; cy: number }) {
  return <path class="paper-mark" d={`M${cx} ${cy - 6}L${cx + 5} ${cy}L${cx} ${cy + 6}L${cx - 5} ${cy}Z`} />;
}

/** What the marks of the bars mean. */
export function BarKey({ isCompared }: { isCompared: boolean }) {
  return (
    <p class="key">
      <KeyEntry text="valid index and its error" box="0 0 24 12">
        <rect class="bar" x={0} y={2} width={18} height={8} />
        <ErrorBar class="error-bar" isLying at={6} ends={[12, 23]} cap={3} />
      </KeyEntry>
      {isCompared && (
        <KeyEntry text="M-DRM where its product form is broken">
          <circle class="mdrm-mark" cx={6} cy={6} r={4.5} />
        </KeyEntry>
      )}
      {isCompared && (
        <KeyEntry text="the paper's Table 2">
          <Diamond cx={6} cy={6} />
        </KeyEntry>
      )}
    </p>
  );
}
