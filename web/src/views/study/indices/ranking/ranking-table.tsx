import { address } from "../../../../api.ts";
import { directionName, DIRECTIONS, type Direction } from "../../../../lib/direction.ts";
import { fixed, MISSING, rankWords } from "../../../../lib/format.ts";
import { methodName, statusName } from "../../../../lib/study/output-words.ts";
import { paperPercent } from "../../../../lib/study/paper/paper-table.ts";
import { byRank, centreOutput, largest, productFormBroken, scoreOf, type Score } from "../../../../lib/study/result-picks.ts";
import type { RankedLocation, StudyResult } from "../../../../wire.ts";
import { ScrollTable } from "../../../shared/scroll-table.tsx";

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

const GSI = scoreColumn("GSI %", "gsi", "100 times the first-order index of this location's own depth for the strain at the centre");
const MDRM = scoreColumn("M\u2011DRM %", "mdrm_gsi", "What M-DRM's product form gives, valid or not");

const PAPER: Column = { title: "Paper %", hint: "Table 2 of the paper", value: (row, direction) => paperPercent(row.name, direction) };

/** Other scores. */
const OTHERS: readonly Column[] = [
  scoreColumn("Mean %", "mean_gsi", "Mean of this depth's index over the strains at all locations"),
  scoreColumn("Own %", "own_gsi", "Index of this depth for the strain at this location itself"),
];

/** Columns without marks of their own. */
const othersOf = (isCompared: boolean): readonly Column[] => (isCompared ? [PAPER, ...OTHERS] : OTHERS);

/** Those, the index, its comparison and the rank by the direction alone. */
const columnsOf = (isCompared: boolean): number => othersOf(isCompared).length + (isCompared ? 3 : 2);

/** Locations best first, with every figure that bears on their rank. */
export function RankingTable({ result, isCompared }: { result: StudyResult; isCompared: boolean }) {
  const columns = columnsOf(isCompared);
  const rows = byRank(result);
  return (
    <ScrollTable name="Ranked locations" kind="ranking" csv={address(result.study.id, "export?format=csv&table=locations")}>
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
            <th key={direction} colSpan={columns} scope="colgroup" class="group">
              Strain {directionName(direction)}
            </th>
          ))}
        </tr>
        <tr>
          {DIRECTIONS.map((direction) => (
            <DirectionHead key={direction} direction={direction} broken={productFormBroken(result, direction)} isCompared={isCompared} />
          ))}
        </tr>
      </thead>
      <tbody>
        {rows.map((row) => (
          <tr key={row.name} data-location={row.name}>
            <td class="rank">{rankWords(row.rank, rows)}</td>
            <td>{row.rank_certain ? "yes" : "no"}</td>
            <th scope="row">{row.name}</th>
            {DIRECTIONS.map((direction) => (
              <DirectionCells key={direction} row={row} rows={rows} result={result} direction={direction} isCompared={isCompared} />
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
            <td key={direction} colSpan={columns} class="group words">
              <Method result={result} direction={direction} />
            </td>
          ))}
        </tr>
      </tfoot>
    </ScrollTable>
  );
}

function DirectionHead({ direction, broken, isCompared }: { direction: Direction; broken: boolean; isCompared: boolean }) {
  return (
    <>
      <th scope="col" class="group" title={GSI.hint}>
        {GSI.title}
      </th>
      {isCompared && (
        <th scope="col" title={MDRM.hint}>
          {MDRM.title}
          {broken && <span class="flag"> not valid</span>}
        </th>
      )}
      {othersOf(isCompared).map((column) => (
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
  isCompared: boolean;
}

function DirectionCells({ row, rows, result, direction, isCompared }: CellsProps) {
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
      {isCompared && <td class={`${strong(MDRM)} ${broken ? "invalid" : ""}`}>{fixed(MDRM.value(row, direction), 2)}</td>}
      {othersOf(isCompared).map((column) => (
        <td key={column.title} class={strong(column)}>
          {fixed(column.value(row, direction), 2)}
        </td>
      ))}
      <td>{rankIn(row, rows, direction)}</td>
    </>
  );
}

/** The rank by one direction alone, 2= where several share it. */
function rankIn(row: RankedLocation, rows: RankedLocation[], direction: Direction): string {
  const ranks = rows.flatMap((each) => each[`rank_${direction}`] ?? []);
  const rank = row[`rank_${direction}`];
  return rank == null
    ? MISSING
    : rankWords(
        rank,
        ranks.map((each) => ({ rank: each })),
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
