import { countDots, type Dot, type DotBlock, type DotRow } from "../../../lib/study/progress/point-grid.ts";
import { integer } from "../../../lib/format.ts";

const [STEP, ROW, LEFT, RADIUS] = [20, 20, 64, 5.5];

/** The points of the plan, filled as they are solved. */
export function PointDots({ blocks }: { blocks: readonly DotBlock[] }) {
  const [solved, failed] = [countDots(blocks, "solved"), countDots(blocks, "failed")];
  return (
    <figure class="point-dots">
      <div class="point-blocks">
        {blocks.map((block) => (
          <Block key={block.title} block={block} />
        ))}
      </div>
      <figcaption class="quiet">
        A dot is a solve, a row an input at its Gauss nodes; the ring in the middle has all inputs at their means and is shared by all rows. Solved in this run:{" "}
        {integer(solved)}
        {failed > 0 && `, without an answer: ${integer(failed)}`}.
      </figcaption>
    </figure>
  );
}

function Block({ block }: { block: DotBlock }) {
  const most = Math.max(...block.rows.map(({ dots, cut }) => dots.length + (cut === null ? 0 : 1)));
  const [width, height] = [LEFT + most * STEP, block.rows.length * ROW];
  return (
    <div>
      <p class="point-block-title">{block.title}</p>
      <svg
        width={width}
        height={height}
        viewBox={`0 0 ${width} ${height}`}
        role="img"
        aria-label={`${block.title}: ${countDots([block], "solved")} points solved`}
      >
        {block.rows.map((row, index) => (
          <g key={row.name} transform={`translate(0 ${index * ROW})`}>
            <text x="0" y={ROW / 2 + 4}>
              {row.name.length > 8 ? `${row.name.slice(0, 7)}…` : row.name}
            </text>
            <Row row={row} cut={block.cut} />
          </g>
        ))}
      </svg>
    </div>
  );
}

function Row({ row, cut }: { row: DotRow; cut: Dot }) {
  const at = (place: number): number => LEFT + (place + 0.5) * STEP;
  return (
    <>
      {row.cut !== null && <circle class={`dot dot-cut dot-${cut}`} cx={at(row.cut)} cy={ROW / 2} r={RADIUS + 1} />}
      {row.dots.map((dot, index) => (
        <circle key={index} class={`dot dot-${dot}`} cx={at(row.cut !== null && index >= row.cut ? index + 1 : index)} cy={ROW / 2} r={RADIUS} />
      ))}
    </>
  );
}
