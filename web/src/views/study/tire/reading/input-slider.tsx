import { significant } from "../../../../lib/format.ts";
import { unitOf, valueAt, type Between } from "../../../../lib/tire/surface/section-lines.ts";
import type { TireModel } from "../tire-model.ts";
import type { Sections } from "../../../../wire.ts";

interface Props {
  model: TireModel;
  quantityIsStrain: boolean;
  value: number | null;
  onWant: () => void;
  onValue: (value: number | null) => void;
}

const STEPS = 200;

/** Moves the tire over the solved values of the input: nothing is solved for it. */
export function InputSlider({ model, quantityIsStrain, value, onWant, onValue }: Props) {
  const { line, inputName } = model;
  return (
    <section class="input-slider" aria-labelledby="slider-title">
      <h3 id="slider-title">Vary {inputName}</h3>
      {line === null && (
        <button type="button" onClick={onWant}>
          Load the solves along {inputName}
        </button>
      )}
      {line?.status === "loading" && (
        <p class="quiet" role="status">
          Loading the solves …
        </p>
      )}
      {line?.status === "failed" && (
        <p class="quiet" role="status">
          The service has no strains along {inputName} to show: {line.problem.detail ?? line.problem.title}
        </p>
      )}
      {line?.status === "ready" && <Slider {...{ model, quantityIsStrain, value, onValue }} line={line.value} />}
    </section>
  );
}

function Slider({ model, line, quantityIsStrain, value, onValue }: Omit<Props, "onWant"> & { line: Sections }) {
  const [first, last] = [line.nodes[0], line.nodes[line.nodes.length - 1]];
  if (first === undefined || last === undefined || first === last) return <p class="quiet">Only one value was solved.</p>;
  const mean = line.nodes.find((node) => node.cut_point)?.value ?? first.value;
  const unit = unitOf(line.vary);
  return (
    <>
      <label>
        <span class="hidden">
          {line.input}, {unit}
        </span>
        <input
          type="range"
          min={first.value}
          max={last.value}
          step={(last.value - first.value) / STEPS}
          value={value ?? mean}
          aria-valuetext={betweenWords(model.between, unit, mean)}
          onInput={(event) => onValue(event.currentTarget.valueAsNumber)}
        />
      </label>
      <button type="button" class="small-button" disabled={value === null} onClick={() => onValue(null)}>
        At the mean
      </button>
      <p class="slider-words">{betweenWords(model.between, unit, mean)}</p>
      <p class="quiet">
        The outer skin moves as the inner one does; beyond the map the wheel stays as at the means.{" "}
        {!quantityIsStrain && "Indices and deviations are of the whole range: only the strain follows."}
        {(line.failed?.length ?? 0) > 0 && ` ${line.failed?.length ?? 0} values have no solve: ${line.failed?.map((each) => each.reason).join("; ") ?? ""}.`}
      </p>
    </>
  );
}

/** What is solved and what lies between. */
function betweenWords(between: Between | null, unit: string, mean: number): string {
  const words = (value: number): string => `${significant(value, 3)}${unit === "" ? "" : ` ${unit}`}`;
  if (between === null) return `Solved, at the mean of ${words(mean)}.`;
  const { low, high, share } = between;
  if (share === 0) return `Solved at ${words(low.value)}.`;
  return `${words(valueAt(between))}: interpolated between the solved ${words(low.value)} and ${words(high.value)}.`;
}
