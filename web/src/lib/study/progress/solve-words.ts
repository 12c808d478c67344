/** How far a solve under way is, in words and as a share. */

import type { LiveSolve } from "../../../wire.ts";

/** Relative residual of an equilibrium, as the service's solver has it. */
const CONVERGED = 1e-8;
const STAGES: Record<LiveSolve["stage"], string> = { inflating: "inflating", pressing: "pressing" };

export function solveWords({ ordinal, stage, share, iterations, residual }: LiveSolve): string {
  const way = share > 0 ? ` from ${Math.round(100 * share)} %` : "";
  const size = residual == null ? "" : `, residual ${residual.toExponential(0)}`;
  return `Point ${ordinal}: ${STAGES[stage]}${way}, iteration ${iterations}${size}`;
}

/** How far down a residual is from 1 to that of an equilibrium, by its digits: 0 to 1. */
export function residualShare({ residual }: Pick<LiveSolve, "residual">): number {
  if (residual == null || residual <= 0) return residual === 0 ? 1 : 0;
  return Math.min(1, Math.max(0, Math.log10(residual) / Math.log10(CONVERGED)));
}
