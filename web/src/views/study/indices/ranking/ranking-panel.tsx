import { byRank, centreName, isRanked } from "../../../../lib/study/result-picks.ts";
import type { StudyResult } from "../../../../wire.ts";
import { Term } from "../../../shared/term/term.tsx";
import { BarKey, Bars } from "./bars.tsx";
import { ProductFormNotice } from "./product-form.tsx";
import { RankingTable } from "./ranking-table.tsx";

/** Where to glue first: the ranking, its bars, and what its order means. */
export function RankingPanel({ result, isCompared }: { result: StudyResult; isCompared: boolean }) {
  if (result.locations.length === 0) return <p class="quiet">The study ranked no location.</p>;
  if (!isRanked(result)) return <Unranked />;
  return (
    <section class="panel" aria-labelledby="ranking-title">
      <h2 id="ranking-title">Ranking</h2>
      <Headline result={result} />
      <div class="bars">
        <Bars result={result} direction="x" isCompared={isCompared} />
        <Bars result={result} direction="y" isCompared={isCompared} />
      </div>
      <BarKey isCompared={isCompared} />
      {isCompared && <ProductFormNotice result={result} direction="x" />}
      {isCompared && <ProductFormNotice result={result} direction="y" />}
      <RankingTable result={result} isCompared={isCompared} />
      <p class="quiet">
        <Term of="gsi">GSI</Term>: <Term of="first-order index" /> of each location's own contact depth for the strain at {centreName(result)}, percent of its
        variance; ± is the estimated absolute error in percentage points. Certain: whether the errors leave no doubt about the rank.
      </p>
      <Meaning centre={centreName(result) ?? "the centre"} />
    </section>
  );
}

function Unranked() {
  return (
    <section class="panel" aria-labelledby="ranking-title">
      <h2 id="ranking-title">Ranking</h2>
      <p class="headline">Nothing here ranks the places: a place is ranked by the contact depth below it, and no such depth varies.</p>
      <p class="quiet">How much each input tells at each place stands under "All outputs by all inputs".</p>
    </section>
  );
}

function Headline({ result }: { result: StudyResult }) {
  const first = byRank(result)[0];
  if (first === undefined) return null;
  return (
    <p class="headline">
      <strong>{first.name}</strong> ranks first
      {first.rank_certain ? "; the errors leave no doubt about it." : ", but the errors leave doubt about it."}
    </p>
  );
}

function Meaning({ centre }: { centre: string }) {
  return (
    <div class="meaning">
      <h3>What this order means</h3>
      <p>
        Each location is scored by how much of the variation of the strain at {centre}, the deformation centre, comes from the contact depth at that location
        alone: 100 times its first-order Sobol index, as in the paper's Table 2. The rank goes by the sum of the figures for x and y. It is one choice among
        several, and <strong>other averages rank otherwise</strong>: <em>mean</em> averages the index over the strains at all locations, <em>own</em> takes the
        strain at the location itself. The largest figure of each column is set in bold; where the bold moves, the order depends on the question.
      </p>
    </div>
  );
}
