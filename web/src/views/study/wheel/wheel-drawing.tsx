import { apartOf, innerRadius, onWheel, type WheelFilm, type WheelShape } from "../../../lib/layouts/wheel-films.ts";
import type { LocationStrain } from "../../../wire.ts";

/** Half of the picture's width; the tire takes most of it. */
const HALF = 160;
const TIRE = 148;
const FOOT = 172;
/** Names of the places stand this far apart. */
const LABELS_APART = 36;
/** A film as drawn, long and wide; its own size where it is known. */
const FILM_MM: [number, number] = [8, 2.6];
/** Films at one place stand this far apart, so that both are seen. */
const BESIDE = 9;

interface Props {
  shape: WheelShape;
  /** How far the ground presses into the outer radius, mm. */
  depth_mm: number;
  films: readonly WheelFilm[];
  size_mm: readonly number[] | null;
  /** The wheel's own angle that touches down. */
  contact_deg: number;
  /** The film that keys and pointer move. */
  chosen?: number | null;
  /** P1, P2, ... with the best ones named. */
  places: readonly LocationStrain[];
  best: readonly string[];
  /** Words in the middle. */
  lines: readonly string[];
  label: string;
}

/** The wheel from the side: tire, ground, the films of a layout, and P1 to P5 at the contact. */
export function WheelDrawing({ shape, depth_mm, films, size_mm, contact_deg, chosen = null, places, best, lines, label }: Props) {
  const scale = TIRE / shape.outer_mm;
  const rim = scale * rimRadius(shape);
  const inner = scale * innerRadius(shape, 0);
  const ground = TIRE - scale * depth_mm;
  return (
    <svg class="wheel" viewBox={`${-HALF} ${-HALF} ${2 * HALF} ${HALF + FOOT}`} role="img" aria-label={label}>
      <circle class="wheel-tire" r={TIRE} />
      <circle class="wheel-air" r={inner} />
      <circle class="wheel-rim" r={rim} />
      <rect class="wheel-ground" x={-HALF} y={ground} width={2 * HALF} height={FOOT - ground} />
      <path class="wheel-ground-line" d={`M${-HALF} ${ground}H${HALF}`} />
      <ZeroMark radius={rim} contact_deg={contact_deg} />
      {films.map((film, k) => (
        <Film
          key={k}
          film={film}
          isChosen={k === chosen}
          beside={besideOf(films, k)}
          radius={scale * innerRadius(shape, film.section_deg)}
          scale={scale}
          size_mm={size_mm}
          contact_deg={contact_deg}
        />
      ))}
      {places.map(({ name, theta_deg }, k) => (
        <Place
          key={name}
          name={name}
          theta_deg={theta_deg}
          radius={inner}
          ground={ground}
          isBest={best.includes(name)}
          labelX={LABELS_APART * (k - (places.length - 1) / 2)}
        />
      ))}
      {lines.map((line, k) => (
        <text key={line} class={k === 0 ? "wheel-word wheel-first" : "wheel-word"} y={18 * (k - (lines.length - 1) / 2) + 4} text-anchor="middle">
          {line}
        </text>
      ))}
    </svg>
  );
}

const rimRadius = ({ outer_mm, section_mm, bead_deg }: WheelShape): number => outer_mm - section_mm + section_mm * Math.cos((bead_deg * Math.PI) / 180);

/** How many films before this one are at its place. */
function besideOf(films: readonly WheelFilm[], index: number): number {
  const film = films[index];
  return films.slice(0, index).filter((other) => other.theta_deg === film?.theta_deg && other.section_deg === film.section_deg).length;
}

interface FilmProps {
  film: WheelFilm;
  isChosen: boolean;
  beside: number;
  radius: number;
  scale: number;
  size_mm: readonly number[] | null;
  contact_deg: number;
}

/** Films around the wheel are seen from the edge, along their length; those across it from their end. */
function Film({ film, isChosen, beside, radius, scale, size_mm, contact_deg }: FilmProps) {
  const apart = apartOf(film, contact_deg);
  const { x, y } = onWheel(radius - 3 - BESIDE * beside, apart);
  const [length = FILM_MM[0], width = FILM_MM[1]] = size_mm ?? FILM_MM;
  const along = Math.abs(Math.cos((film.angle_deg * Math.PI) / 180));
  const drawn = scale * Math.max(width * Math.sqrt(1 - along * along), length * along);
  const kind = film.angle_deg === 0 ? "film-x" : film.angle_deg === 90 ? "film-y" : "film-other";
  return (
    <rect
      class={`wheel-film ${kind}${isChosen ? " wheel-chosen" : ""}`}
      x={-drawn / 2}
      y={-3.5}
      width={drawn}
      height={7}
      rx={1.5}
      transform={`translate(${x} ${y}) rotate(${-apart})`}
    />
  );
}

/** Shows how far the wheel is turned. */
function ZeroMark({ radius, contact_deg }: { radius: number; contact_deg: number }) {
  const { x, y } = onWheel(radius - 9, -contact_deg);
  return <circle class="wheel-zero" cx={x} cy={y} r={4} />;
}

/** Places are named below the ground, where there is room. */
function Place(props: { name: string; theta_deg: number; radius: number; ground: number; labelX: number; isBest: boolean }) {
  const { name, theta_deg, radius, ground, labelX, isBest } = props;
  const from = onWheel(radius, theta_deg);
  return (
    <g class={isBest ? "wheel-place wheel-best" : "wheel-place"}>
      <path d={`M${from.x} ${from.y}L${labelX} ${ground + 8}`} />
      <text x={labelX} y={ground + 21} text-anchor="middle">
        {name}
      </text>
    </g>
  );
}
