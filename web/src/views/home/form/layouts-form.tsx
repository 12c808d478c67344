import { isTable, valueAt } from "../../../lib/document/document-values.ts";
import { directionSets, layoutSize, listIn, setsNamed, type DirectionSets } from "../../../lib/document/form/layout-fields.ts";
import { FormGroup } from "./form-group.tsx";
import { faultsAt, type FormProps } from "./form-props.ts";
import { FieldFaults, NumberBox } from "./number-control.tsx";
import { useTyped } from "./use-typed.ts";

const POSITIONS = ["crown", "shoulder", "sidewall"] as const;
/** The common menu. */
const START = {};
const SETS: readonly { value: DirectionSets; label: string }[] = [
  { value: "both", label: "x and y, alone and together" },
  { value: "y", label: "y, meridional" },
  { value: "x", label: "x, circumferential" },
  { value: "all", label: "all three, compared" },
];

/** The layouts of films that are scored. */
export function LayoutsForm(props: FormProps) {
  const { full, write } = props;
  const isOn = isTable(valueAt(full, "/layouts"));
  return (
    <FormGroup title="Films and layouts">
      <label class="switch">
        <input type="checkbox" checked={isOn} onChange={(event) => write("/layouts", event.currentTarget.checked ? START : undefined)} /> Score layouts of films
      </label>
      {isOn && <Question {...props} />}
      {isOn && <Layouts {...props} />}
    </FormGroup>
  );
}

const ASKED = [
  { name: "films", label: "films at most" },
  { name: "angle_deg", label: "angle error at most, degrees" },
  { name: "force_n", label: "force error at most, N" },
] as const;

/** What is asked of the layouts: empty boxes ask for the knee. */
function Question({ full, faults, write }: FormProps) {
  return (
    <fieldset class="field-row">
      <legend>Question</legend>
      {ASKED.map(({ name, label }) => {
        const pointer = `/question/${name}`;
        const value = valueAt(full, pointer);
        const id = `field-question-${name}`;
        return (
          <label key={name} class="input-box">
            <span>{label}</span>
            <NumberBox
              id={id}
              name={label}
              value={typeof value === "number" ? value : undefined}
              faults={faultsAt(faults, pointer)}
              onChange={(asked) => write(pointer, asked)}
            />
          </label>
        );
      })}
      {isTable(valueAt(full, "/question")) && (
        <button type="button" onClick={() => write("/question", undefined)}>
          Ask nothing
        </button>
      )}
      <FieldFaults id="field-question" faults={ASKED.flatMap(({ name }) => faultsAt(faults, `/question/${name}`))} />
    </fieldset>
  );
}

function Layouts({ full, faults, write }: FormProps) {
  const positions = valueAt(full, "/layouts/positions");
  const chosen: unknown[] = Array.isArray(positions) ? positions : [];
  const sets = directionSets(valueAt(full, "/layouts/directions"));
  const size = layoutSize(valueAt(full, "/layouts/size_mm"));
  const setSize = (length: number, width: number): void => write("/layouts/size_mm", [length, width]);
  const turn = (name: string, on: boolean): void =>
    write(
      "/layouts/positions",
      POSITIONS.filter((each) => (each === name ? on : chosen.includes(each))),
    );
  return (
    <>
      <fieldset class="field-row">
        <legend>Places on the section</legend>
        {POSITIONS.map((name) => (
          <label key={name} class="switch">
            <input type="checkbox" checked={chosen.includes(name)} onChange={(event) => turn(name, event.currentTarget.checked)} /> {name}
          </label>
        ))}
      </fieldset>
      <label class="field-choice">
        Directions of the films{" "}
        <select value={sets} onChange={(event) => write("/layouts/directions", setsNamed(event.currentTarget.value as DirectionSets))}>
          {sets === "own" && <option value="own">as written in the text</option>}
          {SETS.map(({ value, label }) => (
            <option key={value} value={value}>
              {label}
            </option>
          ))}
        </select>
      </label>
      <ListBox label="Numbers of films on the menu" pointer="/layouts/films" value={valueAt(full, "/layouts/films")} faults={faults} write={write} />
      <ListBox label="Units around the wheel" pointer="/layouts/units" value={valueAt(full, "/layouts/units")} faults={faults} write={write} />
      <ListBox
        label="Spacings of units, degrees, each divides 360"
        pointer="/layouts/spacings_deg"
        value={valueAt(full, "/layouts/spacings_deg")}
        faults={faults}
        write={write}
      />
      <ListBox
        label="Depths at which they are scored, mm"
        pointer="/layouts/depths_mm"
        value={valueAt(full, "/layouts/depths_mm")}
        faults={faults}
        write={write}
      />
      <fieldset class="field-row">
        <legend>Film size, mm: points without a size</legend>
        <label class="input-box">
          <span>length</span>
          <NumberBox id="field-film-length" name="Film length, mm" value={size?.[0]} faults={[]} onChange={(length) => setSize(length, size?.[1] ?? length)} />
        </label>
        <label class="input-box">
          <span>width</span>
          <NumberBox id="field-film-width" name="Film width, mm" value={size?.[1]} faults={[]} onChange={(width) => setSize(size?.[0] ?? width, width)} />
        </label>
        {size !== null && (
          <button type="button" onClick={() => write("/layouts/size_mm", undefined)}>
            Points instead
          </button>
        )}
      </fieldset>
      <FieldFaults id="field-layouts" faults={["directions", "size_mm", "positions"].flatMap((name) => faultsAt(faults, `/layouts/${name}`))} />
    </>
  );
}

/** Numbers with commas between them; an empty box takes the list away. */
function ListBox({ label, pointer, value, faults, write }: Pick<FormProps, "faults" | "write"> & { label: string; pointer: string; value: unknown }) {
  const [typed, setTyped] = useTyped();
  const mine = faultsAt(faults, pointer);
  const id = `field${pointer.replaceAll("/", "-")}`;
  return (
    <div class="field field-list">
      <label class="field-label" for={id}>
        {label}
      </label>
      <input
        id={id}
        class="line"
        autocomplete="off"
        placeholder="none"
        value={typed ?? (Array.isArray(value) ? value.join(", ") : "")}
        aria-invalid={mine.length > 0 || (typed !== null && listIn(typed) === null)}
        aria-describedby={mine.length > 0 ? `${id}-faults` : undefined}
        onInput={(event) => {
          const text = event.currentTarget.value;
          setTyped(text);
          const list = listIn(text);
          if (list !== null) write(pointer, list.length === 0 ? undefined : list);
        }}
        onBlur={() => setTyped(null)}
      />
      <FieldFaults id={id} faults={mine} />
    </div>
  );
}
