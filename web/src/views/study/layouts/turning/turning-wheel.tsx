import type { JSX, TargetedPointerEvent } from "preact";
import { useMemo, useRef, useState } from "preact/hooks";
import { layoutWords, short } from "../../../../lib/layouts/layout-words.ts";
import { filmsOf, shapeOf } from "../../../../lib/layouts/wheel-films.ts";
import { angleBound, readings, turnedBy, worstAngle } from "../../../../lib/layouts/wheel-readings.ts";
import type { CutPoint, LayoutFindings, RankedLayout, StudyDetail } from "../../../../wire.ts";
import { Figure } from "../../../shared/picture/figure.tsx";
import { FilmKey } from "../../wheel/film-key.tsx";
import { pointerAngle } from "../../wheel/pointer-angle.ts";
import { WheelDrawing } from "../../wheel/wheel-drawing.tsx";
import { FilmReadings } from "./film-readings.tsx";

interface Props {
  study: StudyDetail;
  cut: CutPoint;
  layout: RankedLayout;
  findings: LayoutFindings;
}

/** Degrees by an arrow key, and with Shift. */
const STEP_DEG = 1;
const LEAP_DEG = 10;

/** The wheel at an angle, what each film reads there, and how well the contact is known. */
export function TurningWheel({ study, cut, layout, findings }: Props) {
  const [contact_deg, turn] = useState(0);
  const films = useMemo(() => filmsOf(layout), [layout]);
  const noise = layout.score.noise_strain ?? layout.score.noise_v ?? 0;
  const worst = useMemo(() => worstAngle(films, findings.rings, noise), [films, findings, noise]);
  const all = readings(films, findings.rings, contact_deg) ?? [];
  const bound_deg = angleBound(all, noise);
  const depth_mm = findings.rings[0]?.depth_mm ?? 0;
  const toWorst = (): void => turn(worst?.contact_deg ?? 0);
  const told = `Contact at ${short(contact_deg)}°. ${boundWords(bound_deg)}`;
  return (
    <div class="turning-body">
      <Figure study={study.name} name="wheel">
        <Turnable contact_deg={contact_deg} onTurn={turn} onWorst={toWorst} words={told}>
          <WheelDrawing
            shape={shapeOf(study.document)}
            depth_mm={depth_mm}
            films={films}
            size_mm={findings.size_mm ?? null}
            contact_deg={contact_deg}
            places={cut.locations}
            best={[]}
            lines={[`${short(contact_deg)}°`, "touches down"]}
            label={`${layoutWords(layout)}, turned to ${contact_deg}°`}
          />
        </Turnable>
        <FilmKey films={films} />
      </Figure>
      <div>
        <p class="headline" role="status">
          {told}
        </p>
        <p class="actions">
          <button type="button" onClick={toWorst}>
            To the worst angle{worst === null ? "" : `, ${worst.contact_deg}°`}
          </button>
        </p>
        <p class="quiet">
          At a depth of {short(depth_mm)} mm. Drag the wheel, or use the arrow keys on it. The error is the Cramér–Rao bound with the depth unknown and a noise
          of {short(noise)} {findings.unit} on each film, whatever it reads: the least that any estimate can reach. Between whole degrees readings are
          interpolated.
        </p>
        <FilmReadings readings={all} noise={noise} unit={findings.unit} />
      </div>
    </div>
  );
}

function boundWords(bound_deg: number | null): string {
  return bound_deg === null ? "The films can't tell the angle here." : `The films tell the angle to ${short(bound_deg, 2)}° at best.`;
}

interface TurnableProps {
  contact_deg: number;
  onTurn: (contact_deg: number) => void;
  onWorst: () => void;
  words: string;
  children: JSX.Element;
}

/** Turns what it shows by the pointer and by keys. */
function Turnable({ contact_deg, onTurn, onWorst, words, children }: TurnableProps) {
  const from = useRef<{ pointer_deg: number; contact_deg: number } | null>(null);

  function press(event: KeyboardEvent): void {
    const by = event.shiftKey ? LEAP_DEG : STEP_DEG;
    const turns: Record<string, number> = { ArrowLeft: -by, ArrowDown: -by, ArrowRight: by, ArrowUp: by };
    const turned = turns[event.key];
    if (turned !== undefined) onTurn(turnedBy(contact_deg, turned));
    else if (event.key.toLowerCase() === "w") onWorst();
    else return;
    event.preventDefault();
  }

  function grip(event: TargetedPointerEvent<HTMLDivElement>): void {
    event.currentTarget.setPointerCapture(event.pointerId);
    from.current = { pointer_deg: pointerAngle(event), contact_deg };
  }

  function drag(event: TargetedPointerEvent<HTMLDivElement>): void {
    if (from.current === null) return;
    // Films move with the pointer: the angle that touches down goes the other way.
    const by = Math.round(from.current.pointer_deg - pointerAngle(event));
    onTurn(turnedBy(from.current.contact_deg, by));
  }

  return (
    <div
      class="turnable"
      tabIndex={0}
      role="slider"
      aria-label="Angle of the wheel that touches down"
      aria-valuemin={0}
      aria-valuemax={359}
      aria-valuenow={contact_deg}
      aria-valuetext={words}
      onKeyDown={press}
      onPointerDown={grip}
      onPointerMove={drag}
      onPointerUp={() => (from.current = null)}
      onPointerCancel={() => (from.current = null)}
    >
      {children}
    </div>
  );
}
