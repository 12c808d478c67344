import { useMemo } from "preact/hooks";
import { frameOf } from "../../lib/chart/frame.ts";
import { significant } from "../../lib/format.ts";
import { lookDrawing } from "../../lib/forces/look-drawing.ts";
import type { ColumnLook, ColumnSeries, RecordingLook } from "../../wire.ts";
import { Chart } from "../shared/chart/chart.tsx";

const [WIDTH, HEIGHT, BESIDE] = [220, 40, 3];
const FRAME = frameOf(WIDTH, HEIGHT, { left: BESIDE, right: BESIDE, top: BESIDE, bottom: BESIDE });

/** A column over time, in a row of a table. */
export function ColumnPicture({ recording, column, series }: { recording: RecordingLook; column: ColumnLook; series: ColumnSeries }) {
  const { band, gaps, lone } = useMemo(() => lookDrawing(recording, column, series, FRAME), [recording, column, series]);
  const range = `from ${significant(column.least, 4)} to ${significant(column.greatest, 4)}`;
  const marks = [gaps.length > 0 && `gaps: ${recording.gaps.count}`, lone.length > 0 && `samples that stand alone: ${column.lone.count}`];
  const label = [`${column.column} over time, ${range}`, ...marks.filter((mark) => mark !== false)].join("; ");
  return (
    <Chart class="column-picture" frame={FRAME} isFixed label={label}>
      {gaps.map(({ x, width }) => (
        <rect key={x} class="look-gap" x={x} y={0} width={width} height={HEIGHT} />
      ))}
      <path class="look-band" d={band} />
      {lone.map(({ x, y }) => (
        <circle key={x} class="look-lone" cx={x} cy={y} r={3} />
      ))}
    </Chart>
  );
}
