import { DIRECTIONS, type Direction } from "../../../lib/direction.ts";
import type { Quantity } from "../../../lib/route.ts";
import { RadioChoice } from "../../shared/radio-choice.tsx";

export const QUANTITY_NAMES: Record<Quantity, string> = {
  index: "First-order index",
  total: "Total index",
  std: "Standard deviation",
  strain: "Strain",
  error: "Error of the index",
  signal: "Film signal",
};

/** What maps show. */
interface Layer {
  direction: Direction;
  quantity: Quantity;
  input: string;
}

interface Props extends Layer {
  /** Of the radio buttons: those of two groups on a page differ. */
  group: string;
  quantities: readonly Quantity[];
  inputs: readonly string[];
  onChoose: (change: Partial<Layer>) => void;
}

/** Chooses the direction, the quantity and the input that maps show. */
export function LayerChoices({ group, direction, quantity, input, quantities, inputs, onChoose }: Props) {
  return (
    <>
      <RadioChoice
        name={`${group}-direction`}
        legend="Direction"
        options={DIRECTIONS.map((value) => ({ value, label: value }))}
        chosen={direction}
        onChoose={(chosen) => onChoose({ direction: chosen })}
      />
      <RadioChoice
        name={`${group}-quantity`}
        legend="Colour by"
        options={quantities.map((value) => ({ value, label: QUANTITY_NAMES[value] }))}
        chosen={quantity}
        onChoose={(chosen) => onChoose({ quantity: chosen })}
      />
      <RadioChoice
        name={`${group}-input`}
        legend="Of the input"
        options={inputs.map((value) => ({ value, label: value }))}
        chosen={input}
        onChoose={(chosen) => onChoose({ input: chosen })}
      />
    </>
  );
}
