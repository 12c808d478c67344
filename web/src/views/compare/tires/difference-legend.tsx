import { microstrain } from "../../../lib/format.ts";
import type { Quantity } from "../../../lib/route.ts";
import type { Field } from "../../../lib/tire/map/surface-field.ts";
import { GREY } from "../../../lib/tire/map/trust.ts";
import { ScaleStrip, Swatch } from "../../study/tire/tire-legend.tsx";

/** The colours of all differences, and what takes them away. */
export function DifferenceLegend({ field, quantity, title }: { field: Field; quantity: Quantity; title: string }) {
  return (
    <figure class="legend">
      <figcaption>{title}; one scale for all</figcaption>
      <ScaleStrip scale={field.scale} />
      <ul class="swatches">
        <li>
          <Swatch colour={GREY} /> {greyWords(field, quantity)}
        </li>
      </ul>
      <p class="quiet">White is no difference, and the line is where it is exactly zero. {errorWords(quantity)}</p>
    </figure>
  );
}

function greyWords({ errors }: Field, quantity: Quantity): string {
  const bound = errors.find((error) => error !== null) ?? null;
  if (quantity === "total") return "No difference. Total indices have no errors of their own, so the colours don't say how far to trust their difference.";
  if (quantity === "index") {
    if (bound === null)
      return "No difference. The errors of the indices aren't known at this level, so the colours don't say how far to trust their difference.";
    return "The difference is within its error, or either strain varies by less than the films' noise; full colour from twice the error on.";
  }
  if (bound === null) return "No difference. The noise of films isn't known here, so the colours don't say how far to trust it.";
  return `The difference is within ${microstrain(bound)} µε, what two films of this noise differ by; full colour from twice that on.`;
}

/** How the error of a difference comes about. */
function errorWords(quantity: Quantity): string {
  if (quantity === "total") return "";
  if (quantity !== "index") return "A map has no errors of strains and deviations by its mesh: the bound is the films' noise times the root of 2.";
  return "Its error here is the root of the squares of both maps' errors, as if they were independent. Two studies' meshes err alike, so it is too large rather than too small; at the ranked places the table below has the service's own error of the difference, which takes that into account.";
}
