import type { TargetedPointerEvent } from "preact";
import { useRef, useState } from "preact/hooks";
import { filmWord, short } from "../../../../lib/layouts/layout-words.ts";
import { added, dropped, MOST_FILMS, movedTo, nearestTo, turnedInto } from "../../../../lib/layouts/moving/moved-films.ts";
import { kindOf } from "../../../../lib/layouts/moving/layout-bounds.ts";
import { shapeOf } from "../../../../lib/layouts/wheel-films.ts";
import type { FilmFields, FilmKindPlace, FilmPlace, StudyDetail, StudyResult } from "../../../../wire.ts";
import { Figure } from "../../../shared/picture/figure.tsx";
import { FilmKey } from "../../wheel/film-key.tsx";
import { pointerAngle } from "../../wheel/pointer-angle.ts";
import { WheelDrawing } from "../../wheel/wheel-drawing.tsx";
import { FilmButtons } from "./film-buttons.tsx";
import type { MovingFilms } from "./use-moved-films.ts";

interface Props {
  study: StudyDetail;
  result: StudyResult;
  fields: FilmFields;
  moved: MovingFilms;
}

/** The wheel whose films are dragged, and their fields for keys. */
export function FilmEditor({ study, result, fields, moved }: Props) {
  const { films, chosen } = moved;
  const drawn = films.map(({ theta_deg, phi_deg, angle_deg }) => ({ theta_deg, section_deg: phi_deg, angle_deg }));
  return (
    <div>
      <Figure study={study.name} name="moved films">
        <Draggable moved={moved}>
          <WheelDrawing
            shape={shapeOf(study.document)}
            depth_mm={fields.loads[0]?.depth_mm ?? 0}
            films={drawn}
            size_mm={fields.size_mm ?? null}
            contact_deg={0}
            chosen={chosen}
            places={result.cut_point.locations}
            best={[]}
            lines={[`${films.length} films`, "drag to move"]}
            label={`${films.length} films that can be moved`}
          />
        </Draggable>
        <FilmKey films={drawn} />
      </Figure>
      <p class="actions">
        <button type="button" disabled={moved.undo === null} onClick={() => moved.undo?.()}>
          Undo
        </button>
        <button type="button" disabled={moved.restart === null} onClick={() => moved.restart?.()}>
          Back to the layout
        </button>
      </p>
      <FilmButtons moved={moved} />
      <Chosen fields={fields} moved={moved} />
      <AddFilm fields={fields} moved={moved} />
      <p class="quiet">On a film: arrow keys move it by 1°, with Shift by 5°; Delete drops it.</p>
    </div>
  );
}

/** Takes the film nearest to the pointer along with it. */
function Draggable({ moved, children }: { moved: MovingFilms; children: preact.JSX.Element }) {
  const held = useRef<number | null>(null);
  const isDragged = useRef(false);

  function grip(event: TargetedPointerEvent<HTMLDivElement>): void {
    held.current = nearestTo(moved.films, pointerAngle(event));
    isDragged.current = false;
    if (held.current === null) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    moved.choose(held.current);
  }

  function drag(event: TargetedPointerEvent<HTMLDivElement>): void {
    const index = held.current;
    const theta_deg = Math.round(pointerAngle(event));
    if (index === null || moved.films[index]?.theta_deg === theta_deg) return;
    const films = movedTo(moved.films, index, theta_deg);
    // One step to undo for all of a drag.
    if (isDragged.current) moved.drag(films);
    else moved.change(films, index);
    isDragged.current = true;
  }

  function release(): void {
    held.current = null;
  }

  return (
    <div class="turnable" onPointerDown={grip} onPointerMove={drag} onPointerUp={release} onPointerCancel={release}>
      {children}
    </div>
  );
}

/** What the chosen film is. */
function Chosen({ fields, moved }: { fields: FilmFields; moved: MovingFilms }) {
  const { films, chosen } = moved;
  const film = chosen === null ? undefined : films[chosen];
  if (film === undefined || chosen === null) return null;
  return (
    <p class="film-fields">
      <KindChoice
        label="Kind"
        kinds={fields.kinds}
        value={kindOf(fields, film) ?? 0}
        onChoose={(kind) => moved.change(turnedInto(films, chosen, kind), chosen)}
      />
      <button type="button" onClick={() => moved.change(dropped(films, chosen), null)}>
        Drop this film
      </button>
    </p>
  );
}

/** One film more, at an angle. */
function AddFilm({ fields, moved }: { fields: FilmFields; moved: MovingFilms }) {
  const [kind, setKind] = useState(0);
  const [theta, setTheta] = useState("15");
  const { films } = moved;
  const of = fields.kinds[kind];
  const theta_deg = Number(theta);
  const isPlace = theta.trim() !== "" && Math.abs(theta_deg) <= 360;
  const add = (): void => {
    if (of !== undefined) moved.change(added(films, of, theta_deg), films.length);
  };
  return (
    <p class="film-fields">
      <KindChoice label="New film" kinds={fields.kinds} value={kind} onChoose={(_, index) => setKind(index)} />
      <label>
        at <input class="film-angle" type="number" min={-360} max={360} step={1} value={theta} onInput={(event) => setTheta(event.currentTarget.value)} /> °
      </label>
      <button type="button" disabled={!isPlace || of === undefined || films.length >= MOST_FILMS} onClick={add}>
        Add
      </button>
    </p>
  );
}

interface KindProps {
  label: string;
  kinds: readonly FilmKindPlace[];
  value: number;
  onChoose: (kind: FilmKindPlace, index: number) => void;
}

function KindChoice({ label, kinds, value, onChoose }: KindProps) {
  const choose = (index: number): void => {
    const kind = kinds[index];
    if (kind !== undefined) onChoose(kind, index);
  };
  return (
    <label>
      {label}{" "}
      <select value={value} onChange={(event) => choose(Number(event.currentTarget.value))}>
        {kinds.map((kind, k) => (
          <option key={k} value={k}>
            {kindWords(kind)}
          </option>
        ))}
      </select>
    </label>
  );
}

/** `y, 45° from the crown` */
function kindWords({ phi_deg, angle_deg }: Pick<FilmPlace, "phi_deg" | "angle_deg">): string {
  return `${filmWord(short(angle_deg))}, ${phi_deg === 0 ? "at the crown" : `${short(phi_deg)}° from the crown`}`;
}
