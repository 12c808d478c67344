import { MISSING } from "../../lib/format.ts";
import { layoutRanks, type LayoutRank } from "../../lib/compare/layout-ranks.ts";
import type { Loadable } from "../../state/loadable.ts";
import type { StudyResult } from "../../wire.ts";
import { ScrollTable, words } from "../shared/scroll-table.tsx";

/** Layouts of each study that are followed. */
const MOST = 5;

interface Props {
  layers: readonly { id: string; number: number; name: string }[];
  answers: readonly Loadable<StudyResult>[];
  baseline: string | null;
}

/** The first layouts of every study with their ranks in all of them. */
export function LayoutRanks({ layers, answers, baseline }: Props) {
  const layouts = answers.map((answer) => (answer.status === "ready" ? answer.value.layouts : []));
  if (layouts.every((list) => list.length === 0)) return null;
  const rows = layoutRanks(
    layouts,
    layers.findIndex(({ id }) => id === baseline),
    MOST,
  );
  return (
    <section class="panel" aria-labelledby="layout-ranks-title">
      <h2 id="layout-ranks-title">Ranks of layouts</h2>
      <ScrollTable
        name="Ranks of layouts"
        kind="layout-ranks"
        isTall
        columns={[
          words("Layout"),
          ...layers.map(({ id, number, name }) => ({
            text: (
              <>
                {number}
                {id === baseline && <span class="error"> baseline</span>}
              </>
            ),
            title: name,
          })),
        ]}
      >
        <tbody>
          {rows.map(({ layout, ranks }) => (
            <tr key={layout}>
              <th scope="row" class="words">
                {layout}
              </th>
              {ranks.map((rank, k) => (
                <td key={k}>{rank === null ? MISSING : <Rank of={rank} />}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </ScrollTable>
      <p class="quiet">
        The first {MOST} of each study. 2= is a rank that several share; — a layout that the study hasn't scored. ★ ↑ and ↓ are places gained and lost since the
        baseline, only where the errors leave no doubt about either rank: other ranks may differ by error alone. Places' ranks stand below.
      </p>
    </section>
  );
}

function Rank({ of: { words, isCertain, change } }: { of: LayoutRank }) {
  return (
    <>
      <strong>{words}</strong> <span class="error">{isCertain ? "certain" : "uncertain"}</span>
      {change !== null && change !== 0 && (
        <span class="difference real">
          <span class="star" aria-hidden="true">
            ★
          </span>
          {change > 0 ? "↓" : "↑"}
          {Math.abs(change)}
          <span class="hidden">{change > 0 ? " places lost" : " places gained"}</span>
        </span>
      )}
    </>
  );
}
