import type { Section } from "../../lib/route.ts";
import type { TermName } from "../../lib/shell/terms.ts";
import { TermLine } from "../shared/term/term.tsx";

/** Words that stand in a section's figures and tables; those of its sentences are explained there. */
const WORDS: Record<Section, readonly TermName[]> = {
  answer: [],
  tire: ["first-order index", "total index", "x and y", "θ and φ", "crown", "shoulder", "sidewall", "bead", "µε", "film signal"],
  layouts: ["crown", "shoulder", "sidewall", "x and y", "film signal"],
  indices: ["total index", "x and y", "M-DRM", "decomposition error", "quadrature error", "mesh error", "µε"],
  trade: ["true error", "claimed error", "first-order index", "M-DRM"],
  run: ["cut point", "mesh error", "M-DRM", "crown", "bead"],
  sheet: [],
};

export function SectionTerms({ section }: { section: Section }) {
  const words = WORDS[section];
  return words.length === 0 ? null : <TermLine names={words} />;
}
