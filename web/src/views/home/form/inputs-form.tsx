import { pathOfPointer, valueAt } from "../../../lib/document/document-values.ts";
import {
  commonDepths,
  furtherInput,
  inputsOf,
  PARAMETERS,
  spreadOf,
  withCommonDepths,
  withKind,
  withSpread,
  type InputRow,
  type Spread,
} from "../../../lib/document/form/input-laws.ts";
import { numberFields, type NumberField } from "../../../lib/document/form/scene-fields.ts";
import { FormGroup } from "./form-group.tsx";
import { faultsAt, type FormProps } from "./form-props.ts";
import { FieldFaults, idOf, NumberBox, NumberControl } from "./number-control.tsx";

/** The uncertain fields of the scene and how they are distributed. */
export function InputsForm(props: FormProps) {
  const { full, write } = props;
  const [rows, fields] = [inputsOf(full), numberFields(full)];
  const further = furtherInput(full, fields);
  const written = valueAt(full, "/inputs");
  return (
    <FormGroup title="What is uncertain">
      <DepthsTogether rows={rows} onChange={(spread) => write("/inputs", withCommonDepths(Array.isArray(written) ? written : [], spread))} />
      <ul class="inputs">
        {rows.map((row, index) => (
          <Input key={index} row={row} index={index} fields={fields} {...props} />
        ))}
      </ul>
      <button type="button" disabled={further === null} onClick={() => write(`/inputs/${rows.length}`, further)}>
        Add an input
      </button>
    </FormGroup>
  );
}

const CENTRE: NumberField = { pointer: "/inputs/centre", label: "All contact depths, mean", unit: "mm", low: 0, high: 10_000, usual: [0.2, 3, 0.05] };
const HALF: NumberField = { pointer: "/inputs/half", label: "All contact depths, ±", unit: "mm", low: 0, high: 10_000, usual: [0.05, 1.5, 0.05] };

/** Depths that vary alike are moved by two sliders. */
function DepthsTogether({ rows, onChange }: { rows: readonly InputRow[]; onChange: (spread: Spread) => void }) {
  const spread = commonDepths(rows);
  if (spread === null) return null;
  return (
    <div class="fields">
      <NumberControl field={CENTRE} value={spread.centre} faults={[]} onChange={(centre) => onChange({ ...spread, centre })} />
      <NumberControl field={HALF} value={spread.half} faults={[]} onChange={(half) => onChange({ ...spread, half })} />
    </div>
  );
}

interface InputProps extends FormProps {
  row: InputRow;
  index: number;
  fields: readonly NumberField[];
}

function Input({ row, index, fields, faults, write }: InputProps) {
  const pointer = `/inputs/${index}`;
  const mine = faultsAt(faults, pointer);
  const named = row.name === "" ? `input ${index + 1}` : row.name;
  return (
    <li class="input-row">
      <input
        class="input-name"
        aria-label={`Name of input ${index + 1}`}
        value={row.name}
        onInput={(event) => write(`${pointer}/name`, event.currentTarget.value)}
      />
      <select aria-label={`What ${named} varies`} value={row.vary} onChange={(event) => write(`${pointer}/vary`, event.currentTarget.value)}>
        {fields.every((field) => pathOfPointer(field.pointer) !== row.vary) && <option value={row.vary}>{row.vary}</option>}
        {fields.map((field) => (
          <option key={field.pointer} value={pathOfPointer(field.pointer)}>
            {field.label}
            {field.unit !== "" && `, ${field.unit}`}
          </option>
        ))}
      </select>
      <select
        aria-label={`Distribution of ${named}`}
        value={String(row.distribution.kind ?? "")}
        onChange={(event) => write(`${pointer}/distribution`, withKind(row.distribution, event.currentTarget.value))}
      >
        {Object.keys(PARAMETERS).map((kind) => (
          <option key={kind}>{kind}</option>
        ))}
      </select>
      <Distribution row={row} named={named} pointer={`${pointer}/distribution`} faults={mine} write={write} />
      <button type="button" class="plain" aria-label={`Remove input ${named}`} title="Remove" onClick={() => write(pointer, undefined)}>
        ×
      </button>
      <FieldFaults id={idOf(pointer)} faults={mine} />
    </li>
  );
}

/** A mean with what it varies by, or the parameters of other kinds by their names. */
function Distribution(props: { row: InputRow; named: string; pointer: string; faults: InputProps["faults"]; write: InputProps["write"] }) {
  const { row, named, pointer, faults, write } = props;
  const { distribution } = row;
  const spread = spreadOf(distribution);
  const box = (label: string, name: string, value: unknown, onChange: (value: number) => void) => (
    <label class="input-box" key={label}>
      <span>{label}</span>
      <NumberBox
        id={`${idOf(pointer)}-${name}`}
        value={typeof value === "number" ? value : undefined}
        faults={faults}
        onChange={onChange}
        name={`${named}: ${name}`}
      />
    </label>
  );
  if (spread !== null) {
    const half = distribution.kind === "uniform" ? "half-width" : "standard deviation";
    return (
      <span class="input-boxes">
        {box("mean", "mean", spread.centre, (centre) => write(pointer, withSpread(distribution, { ...spread, centre })))}
        {box("±", half, spread.half, (value) => write(pointer, withSpread(distribution, { ...spread, half: value })))}
      </span>
    );
  }
  const parameters = PARAMETERS[String(distribution.kind)] ?? [];
  return <span class="input-boxes">{parameters.map((name) => box(name, name, distribution[name], (value) => write(`${pointer}/${name}`, value)))}</span>;
}
