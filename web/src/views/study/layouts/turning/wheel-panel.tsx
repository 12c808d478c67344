import { useState } from "preact/hooks";
import { layoutWords } from "../../../../lib/layouts/layout-words.ts";
import { filmsOf } from "../../../../lib/layouts/wheel-films.ts";
import { ringOf } from "../../../../lib/layouts/wheel-readings.ts";
import type { LayoutFindings, RankedLayout } from "../../../../wire.ts";
import { RadioChoice, type Option } from "../../../shared/radio-choice.tsx";
import type { SectionProps } from "../../section-props.ts";
import { MovingPanel } from "../moving/moving-panel.tsx";
import { TurningWheel } from "./turning-wheel.tsx";

/** Layouts to choose from: the best ones. */
const OFFERED = 40;

type Hand = "turn" | "move";

const HANDS: readonly Option<Hand>[] = [
  { value: "turn", label: "Turn the wheel" },
  { value: "move", label: "Move films" },
];

interface Props extends Pick<SectionProps, "study" | "result" | "route" | "onAdjust"> {
  layouts: RankedLayout[];
  findings: LayoutFindings;
}

/** A layout on the wheel, to be turned by hand, and its films to be moved. */
export function WheelPanel({ study, result, layouts, findings, route, onAdjust }: Props) {
  const offered = layouts.slice(0, OFFERED).filter((layout) => isRead(layout, findings));
  const [chosen, setChosen] = useState(0);
  const [hand, setHand] = useState<Hand>(route.films === null ? "turn" : "move");
  // Films of an address are those of one layout: another one, or none, has none there.
  const forget = (): void => {
    if (route.films !== null) onAdjust({ ...route, films: null });
  };
  const choose = (index: number): void => {
    setChosen(index);
    forget();
  };
  const take = (next: Hand): void => {
    setHand(next);
    if (next === "turn") forget();
  };
  const layout = offered[chosen] ?? offered[0];
  if (layout === undefined) return null;
  return (
    <section class="panel turning" aria-labelledby="turning-title">
      <h2 id="turning-title">By hand</h2>
      <RadioChoice name="hand" legend="What the hand does" isLegendHidden options={HANDS} chosen={hand} onChoose={take} />
      <label class="turning-choice">
        Layout{" "}
        <select value={chosen} onChange={(event) => choose(Number(event.currentTarget.value))}>
          {offered.map((each, k) => (
            <option key={k} value={k}>
              {each.rank}. {layoutWords(each)}
            </option>
          ))}
        </select>
      </label>
      {hand === "turn" ? (
        <TurningWheel key={chosen} study={study} cut={result.cut_point} layout={layout} findings={findings} />
      ) : (
        <MovingPanel key={chosen} study={study} result={result} route={route} onAdjust={onAdjust} layout={layout} />
      )}
    </section>
  );
}

/** Whether the study stored what all its films read. */
function isRead(layout: RankedLayout, { rings }: LayoutFindings): boolean {
  const films = filmsOf(layout);
  return films.length > 0 && films.every((film) => ringOf(rings, film) !== null);
}
