export interface Option<T extends string> {
  value: T;
  label: string;
}

interface Props<T extends string> {
  /** Of the group, on the whole page. */
  name: string;
  legend: string;
  /** Only for those who listen: what is chosen can be seen without it. */
  isLegendHidden?: boolean;
  options: readonly Option<T>[];
  chosen: T;
  onChoose: (value: T) => void;
}

/** One of a few, all of them in view. */
export function RadioChoice<T extends string>({ name, legend, isLegendHidden = false, options, chosen, onChoose }: Props<T>) {
  return (
    <fieldset class="choice">
      <legend class={isLegendHidden ? "hidden" : undefined}>{legend}</legend>
      {options.map(({ value, label }) => (
        <label key={value}>
          <input type="radio" name={name} value={value} checked={value === chosen} onChange={() => onChoose(value)} />
          <span>{label}</span>
        </label>
      ))}
    </fieldset>
  );
}
