import { useState } from "preact/hooks";
import { curves, type ShownLoad } from "../../../lib/layouts/layout-curves.ts";
import { loadWords } from "../../../lib/layouts/layout-words.ts";
import type { LayoutLoad, RankedLayout } from "../../../wire.ts";
import { Figure } from "../../shared/picture/figure.tsx";
import { RadioChoice } from "../../shared/radio-choice.tsx";
import { WideDrawing } from "../../shared/wide-drawing.tsx";
import { CurveKey, LayoutPlot } from "./layout-plot.tsx";

/** The plot of errors over numbers of units, at one load or the worst. */
export function LayoutErrors({ study, layouts, loads }: { study: string; layouts: RankedLayout[]; loads: LayoutLoad[] }) {
  const [load, setLoad] = useState<ShownLoad>("worst");
  const scored = loads.filter((each) => each.reason == null);
  const all = curves(layouts, load);
  if (all.length === 0) return null;
  const options = [{ value: "worst", label: "worst" }, ...scored.map((each, k) => ({ value: String(k), label: loadWords(each) }))];
  const shown = scored[load === "worst" ? -1 : load];
  const at = shown === undefined ? "at each layout's worst load" : `at ${loadWords(shown)}`;
  return (
    <>
      <h3>Angle error over the number of units</h3>
      {scored.length > 1 && (
        <RadioChoice
          name="layout-load"
          legend="Load"
          options={options}
          chosen={String(load)}
          onChoose={(value) => setLoad(value === "worst" ? value : Number(value))}
        />
      )}
      <Figure study={study} name="layouts">
        <WideDrawing name="Angle error over the number of units, scrolled sideways">
          <LayoutPlot curves={all} at={at} />
        </WideDrawing>
        <figcaption>
          <CurveKey curves={all} />
          <p class="quiet">
            95 % of simulated contacts, at all angles and with noise on every film, are estimated better than this, {at}; bars are errors by the mesh and by the
            number of simulations.
          </p>
        </figcaption>
      </Figure>
    </>
  );
}
