import { numberIn, rangeWords, sliderRange, usualWords, type NumberField } from "../../../lib/document/form/scene-fields.ts";
import type { Fault } from "../../../wire.ts";
import { useTyped } from "./use-typed.ts";

interface Props {
  field: NumberField;
  /** Undefined where the document leaves it to its default. */
  value: number | undefined;
  faults: readonly Fault[];
  onChange: (value: number) => void;
}

/** A number of the scene: a slider over the usual values, and a box for all that the service takes. */
export function NumberControl({ field, value, faults, onChange }: Props) {
  const id = idOf(field.pointer);
  const slider = value === undefined ? null : sliderRange(field, value);
  const unit = field.unit === "" ? "" : ` ${field.unit}`;
  return (
    <div class="field" data-pointer={field.pointer}>
      <label class="field-label" for={id}>
        {field.label}
        {field.unit !== "" && `, ${field.unit}`}{" "}
        <span class="quiet" title={`${rangeWords(field)} is taken`}>
          usually {usualWords(field)}
        </span>
      </label>
      {slider !== null && (
        <input
          type="range"
          aria-label={`${field.label}, slider`}
          aria-valuetext={`${value}${unit}`}
          min={slider.from}
          max={slider.to}
          step={slider.step}
          value={value}
          onInput={(event) => onChange(Number(event.currentTarget.value))}
        />
      )}
      <NumberBox id={id} value={value} faults={faults} onChange={onChange} />
      <FieldFaults id={id} faults={faults} />
    </div>
  );
}

interface BoxProps {
  id: string;
  /** Where no label names it. */
  name?: string;
  value: number | undefined;
  faults: readonly Fault[];
  onChange: (value: number) => void;
}

/** A box that keeps what is typed until it is left, so that 0. can become 0.5. */
export function NumberBox({ id, name, value, faults, onChange }: BoxProps) {
  const [typed, setTyped] = useTyped();
  const isWrong = faults.length > 0 || (typed !== null && numberIn(typed) === null);
  return (
    <input
      id={id}
      class="number-box"
      inputMode="decimal"
      autocomplete="off"
      aria-label={name}
      placeholder="default"
      value={typed ?? (value === undefined ? "" : String(value))}
      aria-invalid={isWrong}
      aria-describedby={faults.length > 0 ? `${id}-faults` : undefined}
      onInput={(event) => {
        const text = event.currentTarget.value;
        setTyped(text);
        const number = numberIn(text);
        if (number !== null) onChange(number);
      }}
      onBlur={() => setTyped(null)}
    />
  );
}

/** What the service says of a field. */
export function FieldFaults({ id, faults }: { id: string; faults: readonly Fault[] }) {
  if (faults.length === 0) return null;
  return (
    <p id={`${id}-faults`} class="field-fault">
      {faults.map(({ detail }) => detail.charAt(0).toUpperCase() + detail.slice(1)).join(". ")}.
    </p>
  );
}

export function idOf(pointer: string): string {
  return `field${pointer.replaceAll("/", "-")}`;
}
