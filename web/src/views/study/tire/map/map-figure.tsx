import { useEffect, useRef } from "preact/hooks";
import { stepped, type MapGrid, type SurfacePoint } from "../../../../lib/tire/map/map-grid.ts";
import { useWidth } from "../../../shared/chart/use-width.ts";
import type { MapModel } from "../tire-model.ts";
import { MapAxes } from "./map-axes.tsx";
import { paintRaster } from "./map-canvas.ts";
import { anglesAt, mapFrame, xOf, yOf, type MapFrame } from "./map-frame.ts";
import { Contours, FilmMarks, PointMarks } from "./map-marks.tsx";

interface Props {
  model: MapModel;
  title: string;
  point: SurfacePoint | null;
  pinned: SurfacePoint | null;
  onPoint: (point: SurfacePoint | null) => void;
  onPin: (point: SurfacePoint | null) => void;
}

const GUESSED_WIDTH = 560;

/** The unrolled field on a canvas, its axes and marks over it; the pointer and the arrow keys choose a place. */
export function MapFigure({ model, title, point, pinned, onPoint, onPin }: Props) {
  const holder = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const width = useWidth(holder, GUESSED_WIDTH);
  const { shown } = model;
  const frame = mapFrame(model.rulers, width);
  useEffect(() => {
    if (canvas.current !== null && shown !== null) paintRaster(canvas.current, shown.raster, frame);
  }, [shown?.raster, width]);
  if (shown === null) return null;
  const under = (event: MouseEvent): SurfacePoint | null => {
    const box = (event.currentTarget as HTMLElement).getBoundingClientRect();
    return anglesAt(frame, event.clientX - box.left, event.clientY - box.top);
  };
  const press = (event: KeyboardEvent): void => {
    if (event.key === "Enter" && point !== null) onPin(point);
    else if (event.key === "Escape") onPin(null);
    else {
      const next = moved(shown.field, point, event.key);
      if (next === null) return;
      onPoint(next);
    }
    event.preventDefault();
  };
  return (
    <div
      class="map"
      ref={holder}
      tabIndex={0}
      role="application"
      aria-label={`Map: ${title}. Arrow keys move over the grid, Enter pins the place, Escape lets it go.`}
      onPointerMove={(event) => onPoint(under(event))}
      onPointerLeave={() => onPoint(null)}
      onClick={(event) => onPin(under(event))}
      onKeyDown={press}
      style={{ height: `${frame.height}px` }}
    >
      {/* As wide as the lines above it are drawn: paper is of another width than the window. */}
      <canvas ref={canvas} style={{ width: `${frame.width}px` }} />
      <svg width={frame.width} height={frame.height} aria-hidden="true">
        <MapAxes frame={frame} />
        <Contours lines={shown.contours} scale={shown.field.scale} marks={model.places} frame={frame} />
        <FilmMarks films={model.films} size={model.filmSize} frame={frame} />
        <PointMarks marks={model.places} frame={frame} />
        {pinned !== null && <Pin point={pinned} frame={frame} />}
        {point !== null && <Cross point={point} frame={frame} />}
      </svg>
    </div>
  );
}

/** The grid point after a key; null for keys that mean nothing here. */
function moved(grid: MapGrid, point: SurfacePoint | null, key: string): SurfacePoint | null {
  const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[key];
  if (step === undefined) return null;
  return point === null ? stepped(grid, { theta_deg: 0, phi_deg: 0 }, 0, 0) : stepped(grid, point, step[0] as number, step[1] as number);
}

/** The place that stays. */
function Pin({ point, frame }: { point: SurfacePoint; frame: MapFrame }) {
  const [x, y] = [xOf(frame, point.theta_deg), yOf(frame, point.phi_deg)];
  return (
    <g class="pin">
      <circle cx={x} cy={y} r={5} />
      <text x={x + 7} y={y + 17}>
        pin
      </text>
    </g>
  );
}

/** The chosen place, dark on light so that it shows on every colour. */
function Cross({ point, frame }: { point: SurfacePoint; frame: MapFrame }) {
  const [x, y] = [xOf(frame, point.theta_deg), yOf(frame, point.phi_deg)];
  if (x < frame.left || x > frame.right) return null;
  const path = `M${x - 9},${y}H${x - 3}M${x + 3},${y}H${x + 9}M${x},${y - 9}V${y - 3}M${x},${y + 3}V${y + 9}`;
  return (
    <g class="cross">
      <path class="cross-halo" d={path} />
      <path d={path} />
    </g>
  );
}
