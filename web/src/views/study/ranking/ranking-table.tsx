import { directionName, DIRECTIONS, type Direction } from "../../../lib/direction.ts";
import { fixed, MISSING } from "../../../lib/format.ts";
import { methodName, statusName } from "../../../lib/study/output-words.ts";
import { paperPercent } from "../../../lib/study/paper-table.ts";
import { byRank, centreOutput, largest, productFormBroken, scoreOf, type Score } from "../../../lib/study/result-picks.ts";
import type { RankedLocation, StudyResult } from "../../../wire.ts";
import { ScrollTable } from "../../shared/scroll-table.tsx";

/** One figure column, which stands in either direction. */
interface Column {
  title: string;
  hint: string;
  value: (row: RankedLocation, direction: Direction) => number | null;
}

const scoreColumn = (title: string, score: Score, hint: string): Column => ({
  title,
  hint,
  value: (row, direction) => scoreOf(row, score, direction),
});

const GSI = scoreColumn(
  "GSI %", "gsi", "100 times the first-order index of this location's own depth for the strain at the centre",
);
const MDRM = scoreColumn("M\u2011DRM %", "mdrm_gsi", "What M-DRM's product form gives, valid or not");

/** Columns without marks of their own. */
const OTHERS: readonly Column[] = [
  { title: "Paper %", hint: "Table 2 of the paper", value: (row, direction) => paperPercent(row.name, direction) },
  scoreColumn("Mean %", "mean_gsi", "Mean of this depth's index over the strains at all locations"),
  scoreColumn("Own %", "own_gsi", "Index of this depth for the strain at this location itself"),
];

/** Those, and the rank by the direction alone. */
const COLUMNS_OF_A_DIRECTION = OTHERS.length + 3;

/** Locations best first, with every figure that bears on their rank. */
export function RankingTable({ result }: { result: StudyResult }) {
  const rows = byRank(result);
  return (
    <ScrollTable name="Ranked locations" kind="ranking">
      <thead>
        <tr>
          <th rowSpan={2} scope="col">
            Rank
          </th>
          <th rowSpan={2} scope="col">
            Certain
          </th>
          <th rowSpan={2} scope="col">
            Place
          </th>
          {DIRECTIONS.map((direction) => (
            <th key={direction} colSpan={COLUMNS_OF_A_DIRECTION} scope="colgroup" class="group">
              Strain {directionName(direction)}
            </th>
          ))}
        </tr>
        <tr>
          {DIRECTIONS.map((direction) => (
            <DirectionHead key={direction} direction={direction} broken={productFormBroken(result, direction)} />
          ))}
        </tr>
      </thead>
      <tbody>
        {rows.map((row) => (
          <tr key={row.name} data-location={row.name}>
            <td class="rank">{row.rank}</td>
            <td>{row.rank_certain ? "yes" : "no"}</td>
            <th scope="row">{row.name}</th>
            {DIRECTIONS.map((direction) => (
              <DirectionCells key={direction} row={row} rows={rows} result={result} direction={direction} />
            ))}
          </tr>
        ))}
      </tbody>
      <tfoot>
        <tr>
          <th colSpan={3} scope="row">
            Method, status
          </th>
          {DIRECTIONS.map((direction) => (
            <td key={direction} colSpan={COLUMNS_OF_A_DIRECTION} class="group words">
              <Method result={result} direction={direction} />
            </td>
          ))}
        </tr>
      </tfoot>
    </ScrollTable>
  );
}

function DirectionHead({ direction, broken }: { direction: Direction; broken: boolean }) {
  return (
    <>
      <th scope="col" class="group" title={GSI.hint}>
        {GSI.title}
      </th>
      <th scope="col" title={MDRM.hint}>
        {MDRM.title}
        {broken && <span class="flag"> not valid</span>}
      </th>
      {OTHERS.map((column) => (
        <th key={column.title} scope="col" title={column.hint}>
          {column.title}
        </th>
      ))}
      <th scope="col" title={`Rank by the ${direction} strain alone`}>
        Rank in {direction}
      </th>
    </>
  );
}

interface CellsProps {
  row: RankedLocation;
  rows: RankedLocation[];
  result: StudyResult;
  direction: Direction;
}

function DirectionCells({ row, rows, result, direction }: CellsProps) {
  const error = row[`gsi_${direction}_error_percent`];
  const reason = centreOutput(result, direction)?.error.reason;
  const broken = productFormBroken(result, direction);
  const strong = ({ value }: Column): string => (largest(rows, (other) => value(other, direction)) === row ? "best" : "");
  return (
    <>
      <td class={`group ${strong(GSI)}`}>
        {fixed(GSI.value(row, direction), 2)}
        <span class="error" title={reason ?? undefined}>
          {" "}
          ± {error == null ? "?" : fixed(error, 2)}
        </span>
      </td>
      <td class={`${strong(MDRM)} ${broken ? "invalid" : ""}`}>{fixed(MDRM.value(row, direction), 2)}</td>
      {OTHERS.map((column) => (
        <td key={column.title} class={strong(column)}>
          {fixed(column.value(row, direction), 2)}
        </td>
      ))}
      <td>{row[`rank_${direction}`] ?? MISSING}</td>
    </>
  );
}

function Method({ result, direction }: { result: StudyResult; direction: Direction }) {
  const output = centreOutput(result, direction);
  if (output === null) return <>not in the result</>;
  return (
    <>
      {methodName(output.method)}; {statusName(output.status)}
      {output.reason != null && `: ${output.reason}`}
    </>
  );
}
