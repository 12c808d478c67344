import type { SectionProps } from "../section-props.ts";
import { TradePanel } from "./trade-panel.tsx";

/** What accuracy costs, where that was measured. */
export function TradeView({ trade, study, result }: SectionProps) {
  if (trade !== null) return <TradePanel trade={trade} study={study} level={result.model.level} />;
  return (
    <p class="quiet">
      Nobody has measured what accuracy costs for this study. <code>strainsite trade</code> with its document does, on every mesh and by every method.
    </p>
  );
}
