import { duration, significant } from "../../../lib/format.ts";
import { cheapest, decades, front, marks, type RungMark } from "../../../lib/study/trade/trade-marks.ts";
import { fidelityOf, ownRung, stepWords } from "../../../lib/study/trade/own-rung.ts";
import { placeLabels } from "../../../lib/study/trade/trade-labels.ts";
import type { Rung, StudyDetail, Trade } from "../../../wire.ts";
import { Figure } from "../../shared/figure.tsx";
import { ScrollTable } from "../../shared/scroll-table.tsx";
import { WideDrawing } from "../../shared/wide-drawing.tsx";

const WIDTH = 900;
const HEIGHT = 400;
const LEFT = 62;
const RIGHT = 16;
const TOP = 10;
const FOOT = 40;

type Scale = (value: number) => number;

/** What accuracy costs, measured: time against error, and every rung of the ladder. */
export function TradePanel({ trade, study, level }: { trade: Trade; study: StudyDetail; level: string }) {
  const own = ownRung(trade, fidelityOf(study.document, level));
  const best = cheapest(trade);
  return (
    <section class="panel" aria-labelledby="trade-title">
      <h2 id="trade-title">What a better answer costs</h2>
      <p class="quiet">
        Each rung answers this study with another mesh and method. Errors are the largest of any index that the ranking goes by,
        against {trade.reference.label} ({duration(trade.reference.wall_s)}).{" "}
        {best === null
          ? "No rung ranks the locations as that one does."
          : `The fastest that ranks the locations as that one does is ${best.label} (${duration(best.wall_s)}).`}
      </p>
      <p class="headline">{stepWords(trade, own)}</p>
      <Plot trade={trade} study={study.name} own={own} />
      <Rungs rungs={trade.rungs} />
    </section>
  );
}

function Plot({ trade, study, own }: { trade: Trade; study: string; own: Rung | null }) {
  const [truth, claimed] = [marks(trade, "error_true"), marks(trade, "error_claimed")];
  const all = [...truth, ...claimed];
  const [fast, slow] = decades(all.map((mark) => mark.seconds));
  const [low, high] = decades(all.map((mark) => mark.error));
  const x: Scale = (s) => LEFT + ((WIDTH - LEFT - RIGHT) * (Math.log10(s) - fast)) / (slow - fast);
  const y: Scale = (e) => HEIGHT - FOOT - ((HEIGHT - FOOT - TOP) * (Math.log10(e) - low)) / (high - low);
  const path = front(trade).map((mark, index) => `${index === 0 ? "M" : "L"}${x(mark.seconds)} ${y(mark.error)}`);
  return (
    <Figure study={study} name="trade">
      <WideDrawing name="Time against error, scrolled sideways">
        <svg class="trade-plot" viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label="Time against true and claimed error, both logarithmic">
          <Axes x={x} y={y} seconds={[fast, slow]} errors={[low, high]} />
          <path class="trade-front" d={path.join("")} />
          <Marks of={claimed} x={x} y={y} tone="trade-claimed" word="claimed" />
          <Marks of={truth} x={x} y={y} tone="trade-true" word="true" />
          <Names of={truth} own={own} x={x} y={y} />
        </svg>
      </WideDrawing>
      <figcaption class="key">
        <Key tone="trade-true" text="true error; the line is the Pareto front" />
        <Key tone="trade-claimed" text="error that the rung claims" />
        {own !== null && <Key tone="trade-own" text="this study" />}
      </figcaption>
    </Figure>
  );
}

function Key({ tone, text }: { tone: string; text: string }) {
  return (
    <span>
      <svg viewBox="0 0 12 12" aria-hidden="true">
        <circle class={tone} cx={6} cy={6} r={4} />
      </svg>
      {text}
    </span>
  );
}

function Marks(props: { of: RungMark[]; x: Scale; y: Scale; tone: string; word: string }) {
  return (
    <g>
      {props.of.map(({ rung, seconds, error }) => (
        <circle key={rung.label} class={props.tone} cx={props.x(seconds)} cy={props.y(error)} r={4}>
          <title>{`${rung.label}: ${duration(seconds)}, ${props.word} error ${significant(error, 2)}`}</title>
        </circle>
      ))}
    </g>
  );
}

/** Names of the rungs, the study's own first, so that it has one whatever else fits. */
function Names({ of, own, x, y }: { of: RungMark[]; own: Rung | null; x: Scale; y: Scale }) {
  const inOrder = [...of].sort((a, b) => Number(b.rung === own) - Number(a.rung === own) || Number(b.rung.pareto) - Number(a.rung.pareto));
  const points = inOrder.map(({ rung, seconds, error }) => ({ x: x(seconds), y: y(error), text: rung.label }));
  const mine = of.find(({ rung }) => rung === own);
  return (
    <g class="trade-names">
      {mine !== undefined && <circle class="trade-own" cx={x(mine.seconds)} cy={y(mine.error)} r={8} />}
      {placeLabels(points, WIDTH - RIGHT, HEIGHT - FOOT).map((label) => (
        <text key={label.text} x={label.x} y={label.y} text-anchor={label.anchor} class={label.text === own?.label ? "trade-mine" : undefined}>
          {label.text}
        </text>
      ))}
    </g>
  );
}

function Axes(props: { x: Scale; y: Scale; seconds: [number, number]; errors: [number, number] }) {
  const { x, y } = props;
  const powers = ([low, high]: [number, number]): number[] =>
    Array.from({ length: high - low + 1 }, (_, index) => 10 ** (low + index));
  return (
    <g class="axis">
      {powers(props.seconds).map((s) => (
        <g key={s}>
          <line x1={x(s)} x2={x(s)} y1={TOP} y2={HEIGHT - FOOT} />
          <text x={x(s)} y={HEIGHT - FOOT + 15} text-anchor="middle">
            {significant(s, 1)}
          </text>
        </g>
      ))}
      {powers(props.errors).map((e) => (
        <g key={e}>
          <line x1={LEFT} x2={WIDTH - RIGHT} y1={y(e)} y2={y(e)} />
          <text x={LEFT - 6} y={y(e) + 4} text-anchor="end">
            {significant(e, 1)}
          </text>
        </g>
      ))}
      <text x={(LEFT + WIDTH - RIGHT) / 2} y={HEIGHT - 6} text-anchor="middle">
        wall-clock time, s
      </text>
      <text transform={`translate(12 ${(TOP + HEIGHT - FOOT) / 2}) rotate(-90)`} text-anchor="middle">
        largest error of an index
      </text>
    </g>
  );
}

function Rungs({ rungs }: { rungs: Rung[] }) {
  return (
    <ScrollTable name="Rungs of the trade">
      <thead>
        <tr>
          <th scope="col">Mesh, method, nodes</th>
          <th scope="col">Wall time</th>
          <th scope="col">Solves</th>
          <th scope="col">True error</th>
          <th scope="col">Claimed</th>
          <th scope="col">Ranking</th>
        </tr>
      </thead>
      <tbody>
        {rungs.map((rung) => (
          <tr key={rung.label}>
            <th scope="row">{rung.label}</th>
            <td>{duration(rung.wall_s)}</td>
            <td>{rung.solves}</td>
            <td>{significant(rung.error_true, 2)}</td>
            <td>{significant(rung.error_claimed, 2)}</td>
            <td>{rung.ranking_agrees ? "agrees" : "differs"}</td>
          </tr>
        ))}
      </tbody>
    </ScrollTable>
  );
}
