import type { ComponentChildren } from "preact";
import { directionName, type Direction } from "../../lib/direction.ts";
import { fixed, MISSING, rankWords, signed } from "../../lib/format.ts";
import { formatRoute, studyRoute } from "../../lib/route.ts";
import type { DesignRow, Matrix } from "../../lib/sweep/comparison-matrix.ts";
import type { ComparedIndex, ComparedLocation, Verdict } from "../../wire.ts";
import { ScrollTable, words } from "../shared/scroll-table.tsx";

/** Designs by locations: the index, and below it its difference from the baseline. */
export function DifferenceTable({ matrix, direction }: { matrix: Matrix; direction: Direction }) {
  const cell = (location: ComparedLocation): ComponentChildren => <IndexCell index={location[direction]} />;
  return <ByLocation matrix={matrix} name={`Index and difference, strain ${directionName(direction)}`} cell={cell} />;
}

/** Designs by locations: the rank, and what it was in the baseline. */
export function RankTable({ matrix }: { matrix: Matrix }) {
  return <ByLocation matrix={matrix} name="Ranks" cell={(location, all) => <RankCell location={location} all={all} />} />;
}

/** What stands in a cell, from its location and all of its design. */
type Cell = (location: ComparedLocation, all: readonly ComparedLocation[]) => ComponentChildren;

function ByLocation(props: { matrix: Matrix; name: string; cell: Cell }) {
  const { matrix, name, cell } = props;
  return (
    <ScrollTable name={name} kind="designs" isTall columns={["#", words("Design"), ...matrix.locations]}>
      <tbody>
        {matrix.rows.map((row) => (
          <Row key={row.study.id} row={row} isBaseline={row.study.id === matrix.baseline} cell={cell} />
        ))}
      </tbody>
    </ScrollTable>
  );
}

function Row(props: { row: DesignRow; isBaseline: boolean; cell: Cell }) {
  const { row, isBaseline, cell } = props;
  const all = row.cells.filter((location) => location !== null);
  return (
    <tr class={isBaseline ? "baseline" : undefined}>
      <td>{row.number}</td>
      <th scope="row" class="words">
        <a href={formatRoute(studyRoute(row.study.id))}>{row.study.name}</a>
        {isBaseline && <span class="error"> baseline</span>}
      </th>
      {row.cells.map((location, column) => (
        <td key={column}>{location === null ? MISSING : cell(location, all)}</td>
      ))}
    </tr>
  );
}

function IndexCell({ index }: { index: ComparedIndex }) {
  return (
    <>
      {fixed(index.gsi_percent, 2)} <span class="error">± {errorText(index.error_percent)}</span>
      {index.difference_percent != null && (
        <span class={`difference ${index.verdict ?? ""}`}>
          <Star verdict={index.verdict} />
          {signed(index.difference_percent, 2)} ± {errorText(index.difference_error_percent)}
          <Word verdict={index.verdict} />
        </span>
      )}
    </>
  );
}

function errorText(error: number | null | undefined): string {
  return error == null ? "?" : fixed(error, 2);
}

interface VerdictProps {
  verdict: Verdict | null | undefined;
}

/** A mark for the eye; a word for the ear stands behind the figures. */
function Star({ verdict }: VerdictProps) {
  if (verdict !== "real") return null;
  return (
    <span class="star" aria-hidden="true">
      ★
    </span>
  );
}

function Word({ verdict }: VerdictProps) {
  return verdict == null ? null : <span class="hidden"> {verdict}</span>;
}

function RankCell({ location, all }: { location: ComparedLocation; all: readonly ComparedLocation[] }) {
  const { rank, rank_certain, rank_change, rank_verdict } = location;
  return (
    <>
      <strong>{rankWords(rank, all)}</strong> <span class="error">{rank_certain ? "certain" : "uncertain"}</span>
      {rank_change != null && rank_change !== 0 && rank_verdict === "real" && (
        <span class={`difference ${rank_verdict ?? ""}`}>
          <Star verdict={rank_verdict} />
          {rank_change > 0 ? "↓" : "↑"}
          {Math.abs(rank_change)}
          <span class="hidden">{rank_change > 0 ? " places lost," : " places gained,"}</span>
          <Word verdict={rank_verdict} />
        </span>
      )}
    </>
  );
}
