import type { WheelFilm, WheelShape } from "../../../lib/layouts/wheel-films.ts";

const OUTER = 46;
const CENTRE = { x: 60, y: 58 };

/** Where on the section of the tire the films sit: the crown above, the beads below. */
export function SectionDrawing({ shape, films }: { shape: WheelShape; films: readonly WheelFilm[] }) {
  const inner = (OUTER * (shape.section_mm - shape.wall_mm)) / shape.section_mm;
  const angles = [...new Set(films.map(({ section_deg }) => section_deg))];
  const words = angles.length === 0 ? "no films" : `films ${angles.map((angle) => `${angle}°`).join(", ")} from the crown`;
  return (
    <svg class="wheel-section" viewBox="0 0 120 96" role="img" aria-label={`Section of the tire: ${words}`}>
      <path class="wheel-wall" d={wall(shape.bead_deg, inner)} />
      {angles.map((angle) => (
        <rect key={angle} class="wheel-film wheel-seat" x={-8} y={-2} width={16} height={5} rx={1.5} transform={transformAt(angle, inner - 1.5)} />
      ))}
    </svg>
  );
}

function at(radius: number, angle_deg: number): string {
  const angle = (angle_deg * Math.PI) / 180;
  return `${CENTRE.x + radius * Math.sin(angle)} ${CENTRE.y - radius * Math.cos(angle)}`;
}

function wall(bead_deg: number, inner: number): string {
  const large = bead_deg > 90 ? 1 : 0;
  return `M${at(OUTER, -bead_deg)}A${OUTER} ${OUTER} 0 ${large} 1 ${at(OUTER, bead_deg)}L${at(inner, bead_deg)}A${inner} ${inner} 0 ${large} 0 ${at(inner, -bead_deg)}Z`;
}

const transformAt = (angle_deg: number, radius: number): string => `translate(${at(radius, angle_deg)}) rotate(${angle_deg})`;
