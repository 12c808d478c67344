import { KnownForcesPanel } from "../forces/known-forces-panel.tsx";
import { SignalsPanel } from "../signals/signals-panel.tsx";
import type { SectionProps } from "../section-props.ts";
import { GroundsPanel } from "./grounds-panel.tsx";
import { LayoutsPanel } from "./layouts-panel.tsx";
import { WheelPanel } from "./turning/wheel-panel.tsx";

/** Layouts in their order, and what their films read. */
export function LayoutsView({ result, study, route, onAdjust }: SectionProps) {
  const findings = result.layout_findings ?? null;
  if (result.layouts.length === 0 && result.signals == null) {
    return <p class="quiet">This study asked for no layouts. Add "layouts" to its document to have the films' places around the wheel ranked.</p>;
  }
  return (
    <>
      <LayoutsPanel result={result} findings={findings} />
      {findings !== null && <WheelPanel study={study} result={result} layouts={result.layouts} findings={findings} route={route} onAdjust={onAdjust} />}
      {findings !== null && result.layouts.length > 0 && <GroundsPanel result={result} findings={findings} />}
      {result.forces != null && <KnownForcesPanel layouts={result.layouts} findings={result.forces} />}
      {result.signals != null && <SignalsPanel signals={result.signals} study={study.name} />}
    </>
  );
}
