import { across, frameOf, upwards } from "../../../lib/chart/frame.ts";
import { linear, linearTicks, type Linear } from "../../../lib/chart/scales.ts";
import { significant } from "../../../lib/format.ts";
import type { FilmCurve, Panel } from "../../../lib/study/signals/film-curves.ts";
import { Axis } from "../../shared/chart/axis.tsx";
import { Chart } from "../../shared/chart/chart.tsx";
import { KeyLine } from "../../shared/chart/key.tsx";
import { Curve, type CurveValue } from "../../shared/chart/marks.tsx";
import { Figure } from "../../shared/picture/figure.tsx";

const FRAME = frameOf(460, 230, { left: 46, right: 52, top: 10, bottom: 36 });

const AXES = { load: "load, N", pressure: "pressure, MPa", contact: "contact angle, degrees" } as const;

/** Volts of films along one direction: coupled ones by the left scale, bare ones, which read far more, by the right one. */
export function FilmPlot({ panel, study }: { panel: Panel; study: string }) {
  const x = linear(panel.range, across(FRAME));
  const y = { bare: linear(panel.volts.bare, upwards(FRAME)), coupled: linear(panel.volts.coupled, upwards(FRAME)) };
  const name = `Volts of films along ${panel.direction} in the ${panel.tire} tire over ${AXES[panel.over]}`;
  return (
    <Figure study={study} name={`volts ${panel.tire} ${panel.direction} over ${panel.over}`}>
      <figcaption>
        {panel.tire} tire, films along {panel.direction}
      </figcaption>
      <Chart frame={FRAME} label={name}>
        <Axis side="bottom" frame={FRAME} {...linearTicks(x, 5)} title={AXES[panel.over]} />
        <Axis side="left" frame={FRAME} {...linearTicks(y.coupled, 3)} lines="none" title="coupled V" titlePlace="start" />
        <Axis side="right" frame={FRAME} {...linearTicks(y.bare, 3)} lines="none" title="bare V" titlePlace="start" />
        <Axis side="left" frame={FRAME} values={[0]} at={y.coupled} text={null} />
        {panel.curves.map((curve) => (
          <Curve
            key={`${curve.position} ${curve.film}`}
            class={`film film-${curve.position} film-${curve.film}`}
            values={valuesOf(curve, x, y[curve.film])}
            radius={2.5}
          />
        ))}
      </Chart>
    </Figure>
  );
}

function valuesOf({ points, position, film }: FilmCurve, x: Linear, y: Linear): CurveValue[] {
  return points.map(({ at, volts, error }) => ({
    at: [x(at), y(volts)],
    ends: [y(volts - (error ?? 0)), y(volts + (error ?? 0))],
    title: `${position}, ${film}: ${significant(volts)} ± ${significant(error, 2)} V`,
  }));
}

/** What colours and dashes mean. */
export function FilmKey({ positions }: { positions: string[] }) {
  return (
    <p class="key">
      {positions.map((position) => (
        <KeyLine key={position} class={`film film-${position}`} text={position} />
      ))}
      <KeyLine class="film" text="glued, with its stiffness: left scale" />
      <KeyLine class="film film-bare" text="bare, following the wall: right scale" />
    </p>
  );
}
