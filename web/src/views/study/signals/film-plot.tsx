import { fixed, significant, ticks } from "../../../lib/format.ts";
import { DRAWN, type Drawn, type FilmCurve, type FilmPoint, type Panel } from "../../../lib/study/signals/film-curves.ts";
import { Figure } from "../../shared/figure.tsx";

const WIDTH = 460;
const HEIGHT = 230;
const LEFT = 46;
const RIGHT = 52;
const TOP = 10;
const FOOT = 36;

const AXES = { load: "load, N", pressure: "pressure, MPa", contact: "contact angle, degrees" } as const;

type Scale = (value: number) => number;

const scale = ([low, high]: [number, number], from: number, to: number): Scale => (value) =>
  from + ((to - from) * (value - low)) / (high - low);

/** Volts of films along one direction: coupled ones by the left scale, bare ones, which read far more, by the right one. */
export function FilmPlot({ panel, study }: { panel: Panel; study: string }) {
  const x = scale(panel.range, LEFT, WIDTH - RIGHT);
  const heights = { bare: heightOf(panel, "bare"), coupled: heightOf(panel, "coupled") };
  const name = `Volts of films along ${panel.direction} in the ${panel.tire} tire over ${AXES[panel.over]}`;
  return (
    <Figure study={study} name={`volts ${panel.tire} ${panel.direction} over ${panel.over}`}>
      <figcaption>
        {panel.tire} tire, films along {panel.direction}
      </figcaption>
      <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={name}>
        <Axis panel={panel} x={x} heights={heights} />
        {panel.curves.map((curve) => (
          <Curve key={`${curve.position} ${curve.film}`} curve={curve} x={x} y={heights[curve.film]} />
        ))}
      </svg>
    </Figure>
  );
}

const heightOf = (panel: Panel, film: Drawn): Scale => scale(panel.volts[film], HEIGHT - FOOT, TOP);

function Axis({ panel, x, heights }: { panel: Panel; x: Scale; heights: Record<Drawn, Scale> }) {
  const sides = { coupled: { at: LEFT - 5, anchor: "end" }, bare: { at: WIDTH - RIGHT + 5, anchor: "start" } } as const;
  return (
    <g class="axis">
      {ticks(...panel.range).map((value) => (
        <g key={value}>
          <line x1={x(value)} x2={x(value)} y1={TOP} y2={HEIGHT - FOOT} />
          <text x={x(value)} y={HEIGHT - FOOT + 14} text-anchor="middle">
            {significant(value, 2)}
          </text>
        </g>
      ))}
      {DRAWN.map((film) =>
        ticks(...panel.volts[film], 4).map((value) => (
          <text key={`${film} ${value}`} x={sides[film].at} y={heights[film](value) + 4} text-anchor={sides[film].anchor}>
            {fixed(value, 0)}
          </text>
        )),
      )}
      <line x1={LEFT} x2={WIDTH - RIGHT} y1={heights.coupled(0)} y2={heights.coupled(0)} />
      <text x={(LEFT + WIDTH - RIGHT) / 2} y={HEIGHT - 6} text-anchor="middle">
        {AXES[panel.over]}
      </text>
      <text x={0} y={HEIGHT - 6}>
        coupled V
      </text>
      <text x={WIDTH} y={HEIGHT - 6} text-anchor="end">
        bare V
      </text>
    </g>
  );
}

function Curve({ curve, x, y }: { curve: FilmCurve; x: Scale; y: Scale }) {
  const path = curve.points.map((point, k) => `${k === 0 ? "M" : "L"}${x(point.at)} ${y(point.volts)}`).join("");
  const bar = ({ at, volts, error }: FilmPoint): string => `M${x(at)} ${y(volts - (error ?? 0))}V${y(volts + (error ?? 0))}`;
  return (
    <g class={`film film-${curve.position} film-${curve.film}`}>
      <path d={path} />
      {curve.points.map((point) => (
        <g key={point.at}>
          <path class="film-error" d={bar(point)} />
          <circle cx={x(point.at)} cy={y(point.volts)} r={2.5}>
            <title>{`${curve.position}, ${curve.film}: ${significant(point.volts)} ± ${significant(point.error, 2)} V`}</title>
          </circle>
        </g>
      ))}
    </g>
  );
}

/** What colours and dashes mean. */
export function FilmKey({ positions }: { positions: string[] }) {
  const line = (kind: string) => (
    <svg viewBox="0 0 24 12" aria-hidden="true">
      <g class={kind}>
        <path d="M0 6H24" />
      </g>
    </svg>
  );
  return (
    <p class="key">
      {positions.map((position) => (
        <span key={position}>
          {line(`film film-${position}`)}
          {position}
        </span>
      ))}
      <span>{line("film")}glued, with its stiffness: left scale</span>
      <span>{line("film film-bare")}bare, following the wall: right scale</span>
    </p>
  );
}
