import { cornersOfFilm, type PatchSize, type ShownFilm } from "../../../../lib/tire/surface/film-patches.ts";
import { css } from "../../../../lib/chart/colour.ts";
import { fixed, microstrain, significant } from "../../../../lib/format.ts";
import { contourLabels, type ContourLine } from "../../../../lib/tire/map/contour-lines.ts";
import type { PlaceMark, Scale, ScaleUnit } from "../../../../lib/tire/map/surface-field.ts";
import { endsOf } from "../../../../lib/tire/map/arc-length.ts";
import { xOf, yOf, type MapFrame } from "./map-frame.ts";

/** Room that a label needs, CSS pixels. */
const LABEL_WIDTH = 22;

/** P1, P2, ... */
export function PointMarks({ marks, frame }: { marks: readonly PlaceMark[]; frame: MapFrame }) {
  const at = (mark: PlaceMark): number => xOf(frame, mark.theta_deg);
  const crowded = marks.some((mark, index) => index > 0 && at(mark) - at(marks[index - 1] as PlaceMark) < LABEL_WIDTH);
  return (
    <g class="point-mark">
      {marks.map((mark, index) => (
        <g key={mark.name}>
          <circle cx={at(mark)} cy={yOf(frame, mark.phi_deg)} r={4} />
          {(!crowded || index % 2 === 0) && (
            <text x={at(mark)} y={yOf(frame, mark.phi_deg) - 9} text-anchor="middle">
              {mark.name}
            </text>
          )}
        </g>
      ))}
    </g>
  );
}

/** Room of a line's label, CSS pixels. */
const [CONTOUR_LABEL_WIDTH, CONTOUR_LABEL_HEIGHT] = [46, 15];

const LABELS: Record<ScaleUnit, (value: number) => string> = {
  percent: (value) => `${fixed(100 * value, 0)} %`,
  microstrain,
  volt: (value) => significant(value, 2),
};

/** Lines of equal value; of each value one is labelled. */
export function Contours({ lines, scale, marks, frame }: { lines: readonly ContourLine[]; scale: Scale; marks: readonly PlaceMark[]; frame: MapFrame }) {
  const [wide, high] = [frame.right - frame.left, frame.bottom - frame.top];
  // A mark and its name, which stands above it.
  const taken = marks.flatMap((mark) =>
    [0, 12].map((up) => [(xOf(frame, mark.theta_deg) - frame.left) / wide, (yOf(frame, mark.phi_deg) - up - frame.top) / high] as [number, number]),
  );
  const place = ([x, y]: readonly [number, number]): [number, number] => [frame.left + x * wide, frame.top + y * high];
  const label = (value: number): string => LABELS[scale.unit](value);
  return (
    <g class="contours">
      {lines.map((line, index) => (
        <polyline
          key={index}
          points={line.points
            .map((point) =>
              place(point)
                .map((value) => value.toFixed(1))
                .join(),
            )
            .join(" ")}
        />
      ))}
      {contourLabels(lines, [CONTOUR_LABEL_WIDTH / wide, CONTOUR_LABEL_HEIGHT / high], taken).map(({ value, at }) => {
        const [x, y] = place(at);
        return (
          <text key={value} x={x} y={y + 4} text-anchor="middle">
            {label(value)}
          </text>
        );
      })}
    </g>
  );
}

/** Rim of a coloured film. */
const DARK = "#101820";

/** A film that is a point, CSS pixels. */
const POINT_FILM: PatchSize = [15, 5];

/** The films of a layout: patches of true size, and arrows to those beyond the map. */
export function FilmMarks({ films, size, frame }: { films: readonly ShownFilm[]; size: PatchSize | null; frame: MapFrame }) {
  const [low, high] = endsOf({ angles: [], marks: frame.rulers.along.angles });
  const [shape, scale] = size === null || frame.rulers.unit !== "mm" ? [POINT_FILM, 1] : [size, frame.x(1) - frame.x(0)];
  const inside = films.filter(({ theta_deg }) => theta_deg >= low && theta_deg <= high);
  return (
    <g class="film-marks">
      {inside.map((film, index) => {
        const [x, y] = [xOf(frame, film.theta_deg), yOf(frame, film.phi_deg)];
        const corners = cornersOfFilm(shape, film.angle_deg).map(([u, v]) => `${(x + u * scale).toFixed(1)},${(y - v * scale).toFixed(1)}`);
        return <polygon key={index} points={corners.join(" ")} style={film.colour === undefined ? {} : { fill: css(film.colour), stroke: DARK }} />;
      })}
      <Beyond films={films.filter(({ theta_deg }) => theta_deg > high)} frame={frame} side={1} />
      <Beyond films={films.filter(({ theta_deg }) => theta_deg < low)} frame={frame} side={-1} />
    </g>
  );
}

/** An arrow at the edge for each section angle that has films beyond it. */
function Beyond({ films, frame, side }: { films: readonly ShownFilm[]; frame: MapFrame; side: 1 | -1 }) {
  const edge = side === 1 ? frame.right - 2 : frame.left + 2;
  return (
    <g>
      {[...new Set(films.map(({ phi_deg }) => yOf(frame, phi_deg)))].map((y) => (
        <polygon key={y} points={`${edge},${y} ${edge - 9 * side},${y - 6} ${edge - 9 * side},${y + 6}`} />
      ))}
    </g>
  );
}
