import { frameOf } from "../../../lib/chart/frame.ts";
import type { PreviewRow } from "../../../lib/document/preview/preview-rows.ts";
import { fixed, rankWords } from "../../../lib/format.ts";
import { Chart } from "../../shared/chart/chart.tsx";

const [WIDTH, ROW, BAR] = [320, 30, 9];
const BESIDE = { left: 62, right: 46, top: 0, bottom: 0 };

/** First-order indices of the places, x above y; a mark stands where the draft began. */
export function PreviewBars({ rows, isCompared }: { rows: readonly PreviewRow[]; isCompared: boolean }) {
  if (rows.length === 0) return <p class="quiet">The document ranks no places.</p>;
  const frame = frameOf(WIDTH, rows.length * ROW, BESIDE);
  const at = (percent: number): number => frame.left + (frame.right - frame.left) * Math.min(1, Math.max(0, percent / 100));
  const words = rows.map(({ name, x, y }) => `${name} x ${fixed(x, 0)}, y ${fixed(y, 0)} percent`).join("; ");
  return (
    <figure class="preview-bars">
      <figcaption>
        Which place tells most, % of the variance at the centre: <span class="key-x">x</span> <span class="key-y">y</span>
        {isCompared && " · the line is where you began"}
      </figcaption>
      <Chart frame={frame} label={`Share of the strain's variance at the centre: ${words}`}>
        {rows.map((row, index) => (
          <g key={row.name} transform={`translate(0 ${index * ROW})`}>
            <text class="bar-name" x="0" y="18">
              {row.name}
            </text>
            <text x="28" y="18">
              {rankWords(row.rank, rows)}
              {row.gained > 0 && " ↑"}
              {row.gained < 0 && " ↓"}
            </text>
            <Bar kind="x" value={row.x} before={isCompared ? row.x_before : null} at={at} y={3} />
            <Bar kind="y" value={row.y} before={isCompared ? row.y_before : null} at={at} y={5 + BAR} />
          </g>
        ))}
      </Chart>
    </figure>
  );
}

function Bar({ kind, value, before, at, y }: { kind: "x" | "y"; value: number | null; before: number | null; at: (percent: number) => number; y: number }) {
  const foot = y + BAR;
  if (value === null) {
    return (
      <text x={at(0)} y={foot}>
        {kind}: none
      </text>
    );
  }
  return (
    <>
      <rect class={`preview-bar-${kind}`} x={at(0)} y={y} width={Math.max(1, at(value) - at(0))} height={BAR} />
      {before !== null && <path class="preview-before" d={`M${at(before)} ${y - 2}V${foot + 2}`} />}
      <text class="bar-value" x={at(Math.max(value, before ?? 0)) + 5} y={foot}>
        {fixed(value, 0)}
      </text>
    </>
  );
}
