import { isTable, pathOfPointer, valueAt, withValue, type Table } from "../../../lib/document/document-values.ts";
import { inputsOf } from "../../../lib/document/form/input-laws.ts";
import {
  CAMBER,
  CARCASS,
  depthFields,
  FILM,
  FRICTION,
  GEOMETRY,
  LAWS,
  LOAD,
  PRESSURE,
  STATION_SPACING,
  type NumberField,
} from "../../../lib/document/form/scene-fields.ts";
import { RadioChoice } from "../../shared/radio-choice.tsx";
import { FormGroup } from "./form-group.tsx";
import { faultsAt, type FormProps } from "./form-props.ts";
import { InputsForm } from "./inputs-form.tsx";
import { FieldFaults, NumberControl } from "./number-control.tsx";

/** The tire and what it is pressed on. */
export function SceneForm(props: FormProps) {
  return (
    <>
      <FormGroup title="Tire">
        <Numbers fields={[...GEOMETRY, PRESSURE]} {...props} />
      </FormGroup>
      <Ground {...props} />
      <InputsForm {...props} />
      <Rubber {...props} />
      <Switched title="Carcass" label="Cords in the wall" pointer="/scene/carcass" fields={CARCASS} start={CORDS} {...props} />
      <Switched title="Glued film" label="A film glued on at P3, with its stiffness" pointer="/scene/film" fields={FILM} start={PVDF} {...props} />
    </>
  );
}

/** Of the reference tire. */
const CORDS: Table = { angle_deg: 55, stiffness_n_per_mm: 100, position: 0.5, compression_ratio: 0.01 };
const PVDF: Table = { modulus_mpa: 2500, thickness_mm: 0.028, length_mm: 5, width_mm: 5 };

/** Fields that stand still have a control; the value of one that varies stands with its input. */
function Numbers({ fields, full, faults, write }: FormProps & { fields: readonly NumberField[] }) {
  const varied = new Set(inputsOf(full).map(({ vary }) => vary));
  const varies = ({ pointer }: NumberField): boolean => varied.has(pathOfPointer(pointer));
  const moved = fields.filter(varies).map(({ label }) => label);
  return (
    <>
      <div class="fields">
        {fields
          .filter((field) => !varies(field))
          .map((field) => {
            const value = valueAt(full, field.pointer) ?? field.absent;
            return (
              <NumberControl
                key={field.pointer}
                field={field}
                value={typeof value === "number" ? value : undefined}
                faults={faultsAt(faults, field.pointer)}
                onChange={(number) => writeNumber(full, field.pointer, number, write)}
              />
            );
          })}
      </div>
      {moved.length > 0 && <p class="quiet">Uncertain, so set below: {moved.join(", ")}.</p>}
    </>
  );
}

/** An entry of a list takes the whole list with it: what is laid over a shipped scene replaces lists. */
function writeNumber(full: unknown, pointer: string, value: number, write: FormProps["write"]): void {
  const list = pointer.slice(0, pointer.lastIndexOf("/"));
  const entries = valueAt(full, list);
  if (Array.isArray(entries)) write(list, valueAt(withValue(full, pointer, value), list));
  else write(pointer, value);
}

function Ground(props: FormProps) {
  const { full, replace } = props;
  const isForce = valueAt(full, "/scene/ground/load_n") !== undefined;
  const choose = (by: "depths" | "force"): void => {
    const ground = valueAt(full, "/scene/ground");
    const { depths_mm: _, load_n: __, stations: ___, ...rest } = isTable(ground) ? ground : {};
    const pressed = by === "force" ? { load_n: 13 } : { stations: 5, depths_mm: [1, 1, 1, 1, 1] };
    replace(withValue(full, "/scene/ground", { ...rest, ...pressed }));
  };
  return (
    <FormGroup title="Ground and contact">
      <RadioChoice
        name="ground"
        legend="The ground presses"
        options={[
          { value: "depths", label: "by a depth at each station" },
          { value: "force", label: "flat, by a force" },
        ]}
        chosen={isForce ? "force" : "depths"}
        onChoose={choose}
      />
      <Numbers {...props} fields={[...(isForce ? [LOAD] : depthFields(full)), STATION_SPACING, FRICTION, CAMBER]} />
    </FormGroup>
  );
}

function Rubber(props: FormProps) {
  const { full, faults, write } = props;
  const material = valueAt(full, "/scene/material");
  const table: Table = isTable(material) ? material : {};
  const law = String(table.model ?? "");
  return (
    <FormGroup title="Rubber">
      <label class="field-choice">
        Law{" "}
        <select value={law} onChange={(event) => write("/scene/material", rubberOf(event.currentTarget.value, table))}>
          {LAWS[law] === undefined && <option value={law}>{law === "" ? "default" : law}</option>}
          {Object.entries(LAWS).map(([name, { title }]) => (
            <option key={name} value={name}>
              {title}
            </option>
          ))}
        </select>
      </label>
      <FieldFaults id="field-law" faults={faults.filter(({ pointer }) => pointer === "/scene/material/model" || pointer.startsWith("/scene/material/terms"))} />
      <Numbers {...props} fields={LAWS[law]?.fields ?? []} />
    </FormGroup>
  );
}

/** The table of another law as stiff as the first, its shear modulus 2 (C10 + C01). */
function rubberOf(law: string, { c10_mpa, c01_mpa, d1_per_mpa }: Table): Table {
  const number = (value: unknown, otherwise: number): number => (typeof value === "number" ? value : otherwise);
  const [c10, c01, d1] = [number(c10_mpa, 0.18), number(c01_mpa, 0), number(d1_per_mpa, 0)];
  const sum = Number((c10 + c01).toPrecision(9));
  const parameters: Readonly<Record<string, Table>> = {
    "mooney-rivlin": { c10_mpa: sum, c01_mpa: 0 },
    "neo-hookean": { c10_mpa: sum },
    yeoh: { c10_mpa: sum, c20_mpa: 0, c30_mpa: 0 },
    ogden: { terms: [{ mu_mpa: 2 * sum, alpha: 2 }] },
  };
  return { model: law, ...parameters[law], d1_per_mpa: d1 };
}

interface SwitchedProps extends FormProps {
  title: string;
  label: string;
  pointer: string;
  fields: readonly NumberField[];
  /** What stands there when it is switched on. */
  start: Table;
}

/** A table of the scene that may be absent. */
function Switched({ title, label, pointer, fields, start, ...props }: SwitchedProps) {
  const { full, write, replace } = props;
  const table = valueAt(full, pointer);
  const isOn = isTable(table);
  const isLayered = isOn && "layers" in table;
  const turn = (on: boolean): void => (on ? write(pointer, start) : replace(withValue(full, pointer, undefined)));
  return (
    <FormGroup title={title}>
      <label class="switch">
        <input type="checkbox" checked={isOn} onChange={(event) => turn(event.currentTarget.checked)} /> {label}
      </label>
      {isLayered && <p class="quiet">Its layers are written in the text.</p>}
      {isOn && !isLayered && <Numbers {...props} fields={fields} />}
    </FormGroup>
  );
}
