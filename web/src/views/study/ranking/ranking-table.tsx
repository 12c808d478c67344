import { fixed } from "../../../lib/format.ts";
import { paperPercent } from "../../../lib/study/paper-table.ts";
import { byRank, centreOutput, largest, methodName, productFormBroken, statusName } from "../../../lib/study/result-picks.ts";
import type { Direction, RankedLocation, StudyResult } from "../../../types.ts";
import { directionName } from "../../../lib/direction.ts";

const DIRECTIONS: readonly Direction[] = ["x", "y"];

/** One figure column of a direction. */
interface Column {
  title: string;
  hint: string;
  value: (row: RankedLocation) => number | null;
}

function columns(direction: Direction): { mdrm: Column; paper: Column; mean: Column; own: Column; gsi: Column } {
  const isX = direction === "x";
  return {
    gsi: {
      title: "GSI %",
      hint: "100 times the first-order index of this location's own depth for the strain at the centre",
      value: (row) => (isX ? row.gsi_x_percent : row.gsi_y_percent),
    },
    mdrm: {
      title: "M\u2011DRM %",
      hint: "What M-DRM's product form gives, valid or not",
      value: (row) => (isX ? row.mdrm_gsi_x_percent : row.mdrm_gsi_y_percent),
    },
    paper: { title: "Paper %", hint: "Table 2 of the paper", value: (row) => paperPercent(row.name, direction) },
    mean: {
      title: "Mean %",
      hint: "Mean of this depth's index over the strains at all locations",
      value: (row) => (isX ? row.mean_gsi_x_percent : row.mean_gsi_y_percent),
    },
    own: {
      title: "Own %",
      hint: "Index of this depth for the strain at this location itself",
      value: (row) => (isX ? row.own_gsi_x_percent : row.own_gsi_y_percent),
    },
  };
}

/** Locations best first, with every figure that bears on their rank. */
export function RankingTable({ result }: { result: StudyResult }) {
  const rows = byRank(result);
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label="Ranked locations">
      <table class="ranking" aria-label="Ranked locations">
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
              <th key={direction} colSpan={6} scope="colgroup" class="group">
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
              <td key={direction} colSpan={6} class="group words">
                <Method result={result} direction={direction} />
              </td>
            ))}
          </tr>
        </tfoot>
      </table>
    </div>
  );
}

function DirectionHead({ direction, broken }: { direction: Direction; broken: boolean }) {
  const { gsi, mdrm, paper, mean, own } = columns(direction);
  return (
    <>
      <th scope="col" class="group" title={gsi.hint}>
        {gsi.title}
      </th>
      <th scope="col" title={mdrm.hint}>
        {mdrm.title}
        {broken && <span class="flag"> not valid</span>}
      </th>
      {[paper, mean, own].map((column) => (
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
  const { gsi, mdrm, paper, mean, own } = columns(direction);
  const error = direction === "x" ? row.gsi_x_error_percent : row.gsi_y_error_percent;
  const reason = centreOutput(result, direction)?.error.reason;
  const broken = productFormBroken(result, direction);
  const strong = (column: Column): string => (largest(rows, column.value) === row ? "best" : "");
  return (
    <>
      <td class={`group ${strong(gsi)}`}>
        {fixed(gsi.value(row), 2)}
        <span class="error" title={reason ?? undefined}>
          {" "}
          ± {error == null ? "?" : fixed(error, 2)}
        </span>
      </td>
      <td class={`${strong(mdrm)} ${broken ? "invalid" : ""}`}>{fixed(mdrm.value(row), 2)}</td>
      {[paper, mean, own].map((column) => (
        <td key={column.title} class={strong(column)}>
          {fixed(column.value(row), 2)}
        </td>
      ))}
      <td>{(direction === "x" ? row.rank_x : row.rank_y) ?? "—"}</td>
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
