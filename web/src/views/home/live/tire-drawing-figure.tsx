import { closedPath, linePath, type Point } from "../../../lib/chart/paths.ts";
import { meanAt } from "../../../lib/document/form/input-laws.ts";
import { contactOutline, sectionOutline, type ContactOutline, type SectionOutline } from "../../../lib/document/form/tire-drawing.ts";
import { significant } from "../../../lib/format.ts";
import { ErrorBar } from "../../shared/chart/marks.tsx";

const [WIDTH, HEIGHT, MARGIN] = [220, 170, 12];

/** Section and ground of a draft, to scale and not yet deformed: it follows the fields. */
export function TireDrawing({ full }: { full: unknown }) {
  const [section, contact] = [sectionOutline(full), contactOutline(full)];
  if (section === null) return <p class="quiet">The drawing waits for a wall thinner than the section's radius.</p>;
  const wall = meanAt(full, "/scene/geometry/wall_mm")?.value;
  return (
    <div class="tire-drawings">
      <figure>
        <figcaption>Section across the wheel, wall {wall} mm</figcaption>
        <Section outline={section} label={`Section of the tire with a wall of ${wall} mm`} />
      </figure>
      {contact === null ? (
        <p class="quiet">Flat ground presses by its force: how deep, a solve says.</p>
      ) : (
        <figure>
          <figcaption>Along the wheel: stations, depths, their ranges</figcaption>
          <Contact outline={contact} />
        </figure>
      )}
    </div>
  );
}

/** Fits points into the drawing, one scale both ways unless told otherwise; the crown points down. */
function fitted(points: readonly Point[], stretch = 1): (point: Point) => Point {
  const [xs, zs] = [points.map(([x]) => x), points.map(([, z]) => z)];
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...zs), Math.max(...zs)];
  const scale = Math.min((WIDTH - 2 * MARGIN) / (right - left), (HEIGHT - 2 * MARGIN) / ((high - low) * stretch));
  return ([x, z]) => [WIDTH / 2 + (x - (left + right) / 2) * scale, HEIGHT / 2 - (z - (low + high) / 2) * scale * stretch];
}

function Section({ outline, label }: { outline: SectionOutline; label: string }) {
  const scale = fitted(outline.wall);
  const [, floor] = scale([0, 0]);
  return (
    <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={label}>
      <line class="draw-ground" x1="0" x2={WIDTH} y1={floor + 1.5} y2={floor + 1.5} />
      <path class="draw-wall" d={closedPath(outline.wall.map(scale))} />
      {outline.cords !== null && <path class="draw-cords" d={linePath(outline.cords.map(scale))} />}
    </svg>
  );
}

/** Heights are drawn larger than lengths by this, or depths couldn't be read. */
const STRETCH = 3;

function Contact({ outline }: { outline: ContactOutline }) {
  const { tire, inner, ground, stations } = outline;
  const least = Math.min(0, ...stations.map(({ depth_mm, half_mm }) => depth_mm - half_mm));
  const shown = [...ground, ...inner.filter(([x]) => Math.abs(x) < Math.abs(ground[0]?.[0] ?? 0) * 0.7), [0, least] as const];
  const scale = fitted(shown, STRETCH);
  const label = `Depths of the ground: ${stations.map(({ name, depth_mm, half_mm }) => `${name} ${significant(depth_mm)}${half_mm > 0 ? ` ± ${significant(half_mm)}` : ""} mm`).join(", ")}`;
  return (
    <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={label}>
      <path class="draw-wall" d={closedPath([...tire, ...[...inner].reverse()].map(scale))} />
      <path
        class="draw-earth"
        d={closedPath([...ground, [ground.at(-1)?.[0] ?? 0, least - 50] as const, [ground[0]?.[0] ?? 0, least - 50] as const].map(scale))}
      />
      {stations.map(({ name, x_mm, depth_mm, half_mm }) => {
        const [x, middle] = scale([x_mm, depth_mm]);
        const [, top] = scale([x_mm, depth_mm + half_mm]);
        const [, bottom] = scale([x_mm, depth_mm - half_mm]);
        return (
          <g key={name} class="draw-station">
            {half_mm > 0 && <ErrorBar at={x} ends={[top, bottom]} cap={4} />}
            <circle cx={x} cy={middle} r="3" />
            <text x={x} y={Math.max(11, top - 6)} text-anchor="middle">
              {name}
            </text>
          </g>
        );
      })}
    </svg>
  );
}
