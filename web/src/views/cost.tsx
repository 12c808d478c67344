import { bytes, duration, integer, percent } from "../lib/format.ts";
import type { StudyCost } from "../types.ts";

/** What the answer took. */
export function CostView({ cost }: { cost: StudyCost }) {
  const facts: [string, string][] = [
    ["Points", integer(cost.solves)],
    ["Reused", integer(cost.reused)],
    ["Newton iterations", integer(cost.newton_iterations)],
    ["Wall time", duration(cost.wall_s)],
    ["Processor time", duration(cost.cpu_s)],
    ["Peak memory", bytes(cost.peak_memory_bytes)],
  ];
  return (
    <section class="panel" aria-labelledby="cost-title">
      <h2 id="cost-title">Cost</h2>
      <dl class="facts">
        {facts.map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      <Shares cost={cost} />
    </section>
  );
}

function Shares({ cost }: { cost: StudyCost }) {
  const shares: [string, number, string][] = [
    ["factorisation", cost.factorisation_share, "share-a"],
    ["substitution and contact", cost.substitution_share, "share-d"],
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
