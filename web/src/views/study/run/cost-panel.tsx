import { integer, percent } from "../../../lib/format.ts";
import { compare, took } from "../../../lib/study/expected-cost.ts";
import type { Estimate, StudyCost } from "../../../wire.ts";
import { Facts } from "../../shared/facts.tsx";

/** What the answer took, and what it was expected to take. */
export function CostPanel({ cost, estimate }: { cost: StudyCost; estimate: Estimate | null }) {
  const facts: [string, string][] = [
    ["Points", integer(cost.solves)],
    ["Reused", integer(cost.reused)],
    ["Newton iterations", integer(cost.newton_iterations)],
    ...took(cost),
  ];
  return (
    <section class="panel" aria-labelledby="cost-title">
      <h2 id="cost-title">Cost</h2>
      <Facts facts={facts} />
      <Shares cost={cost} />
      {estimate !== null && <Expected estimate={estimate} cost={cost} />}
    </section>
  );
}

function Expected({ estimate, cost }: { estimate: Estimate; cost: StudyCost }) {
  return (
    <>
      <div class="scroll">
        <table class="estimate">
          <thead>
            <tr>
              <th scope="col">Estimated before</th>
              <th scope="col">expected</th>
              <th scope="col">took</th>
            </tr>
          </thead>
          <tbody>
            {compare(estimate, cost).map(({ what, expected, took }) => (
              <tr key={what}>
                <th scope="row">{what}</th>
                <td>{expected}</td>
                <td>{took}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      {estimate.reasons.map((reason) => (
        <p key={reason} class="quiet">
          {reason}
        </p>
      ))}
    </>
  );
}

function Shares({ cost }: { cost: StudyCost }) {
  const shares: [string, number, string][] = [
    ["factorisation", cost.factorisation_share, "share-a"],
    ["substitution and contact", cost.substitution_share ?? 0, "share-d"],
    ["assembly", cost.assembly_share, "share-b"],
    ["the rest", cost.other_share, "share-c"],
  ];
  const words = shares.map(([name, share]) => `${name} ${percent(share, 0)} %`).join(", ");
  let start = 0;
  return (
    <figure class="shares">
      <svg class="share-bar" viewBox="0 0 100 4" preserveAspectRatio="none" role="img" aria-label={`Time in solves: ${words}`}>
        {shares.map(([name, share, tone]) => {
          const from = start;
          start += 100 * share;
          return <rect key={name} class={tone} x={from} y={0} width={100 * share} height={4} />;
        })}
      </svg>
      <figcaption class="key">
        Time in solves:
        {shares.map(([name, share, tone]) => (
          <span key={name}>
            <svg viewBox="0 0 12 12" aria-hidden="true">
              <rect class={tone} width={12} height={12} />
            </svg>
            {name} {percent(share, 0)} %
          </span>
        ))}
      </figcaption>
    </figure>
  );
}
