import { directionName, type Direction } from "../../../../lib/direction.ts";
import { fixed, MISSING } from "../../../../lib/format.ts";
import { paperPercent } from "../../../../lib/study/paper/paper-table.ts";
import { bars, productFormBroken, type Bar } from "../../../../lib/study/result-picks.ts";
import type { StudyResult } from "../../../../wire.ts";
import { Figure } from "../../../shared/figure.tsx";

const WIDTH = 460;
const LEFT = 34;
const RIGHT = 96;
const TOP = 8;
const ROW = 30;
const FOOT = 34;

const x = (percent: number): number => LEFT + ((WIDTH - LEFT - RIGHT) * Math.min(100, Math.max(0, percent))) / 100;

/** Indices of one direction as bars with error bars; M-DRM's and the paper's figures are marked where they are compared. */
export function Bars({ result, direction, isCompared }: { result: StudyResult; direction: Direction; isCompared: boolean }) {
  const rows = bars(result, direction);
  const broken = productFormBroken(result, direction);
  const height = TOP + ROW * rows.length + FOOT;
  const title = `First-order indices, strain ${directionName(direction)}, percent`;
  const words = rows.map((row) => `${row.name} ${fixed(row.percent, 1)}`).join(", ");
  return (
    <Figure study={result.study.name} name={`indices-${direction}`}>
      <figcaption>Strain {directionName(direction)}</figcaption>
      <svg viewBox={`0 0 ${WIDTH} ${height}`} role="img" aria-label={`${title}: ${words}`}>
        <Axis bottom={height - FOOT} />
        {rows.map((row, index) => (
          <Row key={row.name} row={row} y={TOP + ROW * index} direction={direction} broken={broken} isCompared={isCompared} />
        ))}
      </svg>
    </Figure>
  );
}

function Axis({ bottom }: { bottom: number }) {
  return (
    <g class="axis">
      {[0, 25, 50, 75, 100].map((percent) => (
        <g key={percent}>
          <line x1={x(percent)} x2={x(percent)} y1={TOP} y2={bottom} />
          <text x={x(percent)} y={bottom + 14} text-anchor="middle">
            {percent}
          </text>
        </g>
      ))}
      <text x={x(50)} y={bottom + 29} text-anchor="middle">
        percent of the centre's variance
      </text>
    </g>
  );
}

function Row(props: { row: Bar; y: number; direction: Direction; broken: boolean; isCompared: boolean }) {
  const { row, y, direction, broken, isCompared } = props;
  const middle = y + ROW / 2;
  const paper = isCompared ? paperPercent(row.name, direction) : null;
  return (
    <g>
      <text class="bar-name" x={LEFT - 8} y={middle + 4} text-anchor="end">
        {row.name}
      </text>
      {row.percent !== null && (
        <rect class="bar" x={LEFT} y={y + 7} width={Math.max(0, x(row.percent) - LEFT)} height={ROW - 14} />
      )}
      {row.percent !== null && row.error !== null && (
        <ErrorBar low={x(row.percent - row.error)} high={x(row.percent + row.error)} middle={middle} />
      )}
      {isCompared && row.mdrm !== null && broken && <circle class="mdrm-mark" cx={x(row.mdrm)} cy={middle} r={4.5} />}
      {paper !== null && <Diamond cx={x(paper)} cy={middle} />}
      <text class="bar-value" x={WIDTH - 4} y={middle + 4} text-anchor="end">
        {fixed(row.percent, 1)}
        {row.percent === null ? "" : ` ± ${row.error === null ? MISSING : fixed(row.error, 1)}`}
      </text>
    </g>
  );
}

function ErrorBar({ low, high, middle }: { low: number; high: number; middle: number }) {
  return <path class="error-bar" d={`M${low} ${middle}H${high}M${low} ${middle - 5}V${middle + 5}M${high} ${middle - 5}V${middle + 5}`} />;
}

function Diamond({ cx, cy }: { cx: number; cy: number }) {
  return <path class="paper-mark" d={`M${cx} ${cy - 6}L${cx + 5} ${cy}L${cx} ${cy + 6}L${cx - 5} ${cy}Z`} />;
}

/** What the marks of the bars mean. */
export function BarKey({ isCompared }: { isCompared: boolean }) {
  return (
    <p class="key">
      <span>
        <svg viewBox="0 0 24 12" aria-hidden="true">
          <rect class="bar" x={0} y={2} width={18} height={8} />
          <path class="error-bar" d="M12 6H23M12 3V9M23 3V9" />
        </svg>
        valid index and its error
      </span>
      {isCompared && <ComparedKey />}
    </p>
  );
}

function ComparedKey() {
  return (
    <>
      <span>
        <svg viewBox="0 0 12 12" aria-hidden="true">
          <circle class="mdrm-mark" cx={6} cy={6} r={4.5} />
        </svg>
        M-DRM where its product form is broken
      </span>
      <span>
        <svg viewBox="0 0 12 12" aria-hidden="true">
          <Diamond cx={6} cy={6} />
        </svg>
        the paper's Table 2
      </span>
    </>
  );
}
