import { linePath } from "../../../lib/chart/paths.ts";
import { across, frameOf, upwards } from "../../../lib/chart/frame.ts";
import { decades, logTicks } from "../../../lib/chart/scales.ts";
import { duration, significant } from "../../../lib/format.ts";
import { heading, view } from "../../../lib/study/figures/columns.ts";
import { cheapest, claimedMarks, front, type RungMark, trueMarks } from "../../../lib/study/trade/trade-marks.ts";
import { fidelityOf, ownRung, stepWords } from "../../../lib/study/trade/own-rung.ts";
import { placeLabels } from "../../../lib/study/trade/trade-labels.ts";
import { type Rung, RUNGS_COLUMNS, type StudyDetail, type Trade } from "../../../wire.ts";
import { Axis } from "../../shared/chart/axis.tsx";
import { Chart } from "../../shared/chart/chart.tsx";
import { KeyEntry } from "../../shared/chart/key.tsx";
import { Figure } from "../../shared/picture/figure.tsx";
import { ScrollTable } from "../../shared/scroll-table.tsx";
import { FigureCells } from "../figure-cells.tsx";
import { WideDrawing } from "../../shared/wide-drawing.tsx";

const FRAME = frameOf(900, 400, { left: 62, right: 16, top: 10, bottom: 40 });

type Scale = (value: number) => number;

/** What accuracy costs, measured: time against error, and every rung of the ladder. */
export function TradePanel({ trade, study, level }: { trade: Trade; study: StudyDetail; level: string }) {
  const own = ownRung(trade, fidelityOf(study.document, level));
  const best = cheapest(trade);
  return (
    <section class="panel" aria-labelledby="trade-title">
      <h2 id="trade-title">What a better answer costs</h2>
      <p class="quiet">
        Each rung answers this study with another mesh and method. Errors are the largest of any index that the ranking goes by, against {trade.reference.label}{" "}
        ({duration(trade.reference.wall_s)}).{" "}
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
  const [truth, claimed] = [trueMarks(trade), claimedMarks(trade)];
  const all = [...truth, ...claimed];
  const x = decades(
    all.map((mark) => mark.seconds),
    across(FRAME),
  );
  const y = decades(
    all.map((mark) => mark.error),
    upwards(FRAME),
  );
  return (
    <Figure study={study} name="trade">
      <WideDrawing name="Time against error, scrolled sideways">
        <Chart class="trade-plot" frame={FRAME} label="Time against true and claimed error, both logarithmic">
          <Axis side="bottom" frame={FRAME} {...logTicks(x, [1])} title="wall-clock time, s" />
          <Axis side="left" frame={FRAME} {...logTicks(y, [1])} title="largest error of an index" />
          <path class="trade-front" d={linePath(front(trade).map((mark) => [x(mark.seconds), y(mark.error)]))} />
          <Marks of={claimed} x={x} y={y} tone="trade-claimed" word="claimed" />
          <Marks of={truth} x={x} y={y} tone="trade-true" word="true" />
          <Names of={truth} own={own} x={x} y={y} />
        </Chart>
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
    <KeyEntry text={text}>
      <circle class={tone} cx={6} cy={6} r={4} />
    </KeyEntry>
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
      {placeLabels(points, FRAME.right, FRAME.bottom).map((label) => (
        <text key={label.text} x={label.x} y={label.y} text-anchor={label.anchor} class={label.text === own?.label ? "trade-mine" : undefined}>
          {label.text}
        </text>
      ))}
    </g>
  );
}

const FIGURES = view(RUNGS_COLUMNS, "rungs");

function Rungs({ rungs }: { rungs: Rung[] }) {
  return (
    <ScrollTable name="Rungs of the trade" columns={["Mesh, method, nodes", ...FIGURES.map(heading), "Ranking"]}>
      <tbody>
        {rungs.map((rung) => (
          <tr key={rung.label}>
            <th scope="row">{rung.label}</th>
            <FigureCells columns={FIGURES} row={{ rung }} />
            <td>{rung.ranking_agrees ? "agrees" : "differs"}</td>
          </tr>
        ))}
      </tbody>
    </ScrollTable>
  );
}
