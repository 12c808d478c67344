import type { PreviewRow } from "../../../lib/document/preview/preview-rows.ts";
import { fixed } from "../../../lib/format.ts";

const [WIDTH, ROW, LEFT, BAR] = [320, 30, 62, 9];
const SCALE = (WIDTH - LEFT - 46) / 100;

/** First-order indices of the places, x above y; a mark stands where the draft began. */
export function PreviewBars({ rows, isCompared }: { rows: readonly PreviewRow[]; isCompared: boolean }) {
  if (rows.length === 0) return <p class="quiet">The document ranks no places.</p>;
  const label = `Share of the strain's variance at the centre: ${rows.map(({ name, x, y }) => `${name} x ${fixed(x, 0)}, y ${fixed(y, 0)} percent`).join("; ")}`;
  return (
    <figure class="preview-bars">
      <figcaption>
        Which place tells most, % of the variance at the centre: <span class="key-x">x</span> <span class="key-y">y</span>
        {isCompared && " · the line is where you began"}
      </figcaption>
      <svg viewBox={`0 0 ${WIDTH} ${rows.length * ROW}`} role="img" aria-label={label}>
        {rows.map((row, index) => (
          <g key={row.name} transform={`translate(0 ${index * ROW})`}>
            <text class="bar-name" x="0" y="18">
              {row.name}
            </text>
            <text x="28" y="18">
              {rows.filter(({ rank }) => rank === row.rank).length > 1 ? `${row.rank}=` : row.rank}
              {row.gained > 0 && " ↑"}
              {row.gained < 0 && " ↓"}
            </text>
            <Bar kind="x" value={row.x} before={isCompared ? row.x_before : null} y={3} />
            <Bar kind="y" value={row.y} before={isCompared ? row.y_before : null} y={5 + BAR} />
          </g>
        ))}
      </svg>
    </figure>
  );
}

function Bar({ kind, value, before, y }: { kind: "x" | "y"; value: number | null; before: number | null; y: number }) {
  if (value === null) {
    return (
      <text x={LEFT} y={y + BAR}>
        {kind}: none
      </text>
    );
  }
  const at = (percent: number): number => LEFT + Math.max(0, Math.min(100, percent)) * SCALE;
  return (
    <>
      <rect class={`preview-bar-${kind}`} x={LEFT} y={y} width={Math.max(1, at(value) - LEFT)} height={BAR} />
      {before !== null && <path class="preview-before" d={`M${at(before)} ${y - 2}V${y + BAR + 2}`} />}
      <text class="bar-value" x={Math.max(at(value), before === null ? 0 : at(before)) + 5} y={y + BAR}>
        {fixed(value, 0)}
      </text>
    </>
  );
}
