import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { fixed, ticks } from "../../../lib/format.ts";
import { cellAt, MERIDIONAL_MARKS, type Cell, type Field, type PlaceMark } from "../../../lib/study/surface-field.ts";
import { paintField } from "./map-canvas.ts";
import { anglesAt, cellBox, frameOf, xOf, yOf, type Frame } from "./map-frame.ts";

interface Props {
  field: Field;
  marks: PlaceMark[];
  title: string;
  cell: Cell | null;
  onCell: (cell: Cell | null) => void;
}

/** The field on a canvas, its axes and marks over it; the pointer and the arrow keys choose a cell. */
export function MapFigure({ field, marks, title, cell, onCell }: Props) {
  const holder = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const width = useWidth(holder);
  const frame = frameOf(field, width);
  useEffect(() => {
    if (canvas.current !== null) paintField(canvas.current, field, frame);
  }, [field.values, field.status, field.scale.colour, width]);

  const point = (event: PointerEvent): void => {
    const box = (event.currentTarget as HTMLElement).getBoundingClientRect();
    const { theta_deg, phi_deg } = anglesAt(frame, event.clientX - box.left, event.clientY - box.top);
    onCell(cellAt(field, theta_deg, phi_deg));
  };
  const press = (event: KeyboardEvent): void => {
    const next = moved(field, cell, event.key);
    if (next === undefined) return;
    event.preventDefault();
    onCell(next);
  };
  return (
    <div
      class="map"
      ref={holder}
      tabIndex={0}
      role="application"
      aria-label={`${title}. Arrow keys move over the cells, Escape leaves.`}
      onPointerMove={point}
      onPointerDown={point}
      onPointerLeave={() => onCell(null)}
      onKeyDown={press}
      style={{ height: `${frame.height}px` }}
    >
      <canvas ref={canvas} />
      <svg width={frame.width} height={frame.height} aria-hidden="true">
        <Axes frame={frame} />
        <PointMarks marks={marks} frame={frame} />
        {cell !== null && <rect class="cell cell-halo" {...cellBox(frame, cell)} />}
        {cell !== null && <rect class="cell" {...cellBox(frame, cell)} />}
      </svg>
    </div>
  );
}

function useWidth(holder: { current: HTMLElement | null }): number {
  const [width, setWidth] = useState(640);
  useLayoutEffect(() => {
    const element = holder.current;
    if (element === null) return undefined;
    setWidth(element.clientWidth);
    const observer = new ResizeObserver(() => setWidth(element.clientWidth));
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  return width;
}

/** The cell after a key; undefined for keys that mean nothing here. */
function moved(field: Field, cell: Cell | null, key: string): Cell | null | undefined {
  if (key === "Escape") return null;
  const step = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [1, 0], ArrowDown: [-1, 0] }[key];
  if (step === undefined) return undefined;
  const [rows, columns] = [field.phi_deg.length, field.theta_deg.length];
  if (cell === null) return { row: Math.floor(rows / 2), column: Math.floor(columns / 2) };
  const within = (value: number, count: number): number => Math.min(count - 1, Math.max(0, value));
  return { row: within(cell.row + (step[0] as number), rows), column: within(cell.column + (step[1] as number), columns) };
}

function Axes({ frame }: { frame: Frame }) {
  const [left, right] = [frame.left, frame.left + frame.plotWidth];
  const bottom = frame.top + frame.plotHeight;
  const [first, last] = [frame.thetas[0] as number, frame.thetas[frame.thetas.length - 1] as number];
  const [low, high] = [frame.phis[0] as number, frame.phis[frame.phis.length - 1] as number];
  const shown = MERIDIONAL_MARKS.filter((mark) => mark.phi_deg >= low && mark.phi_deg <= high);
  return (
    <g class="axis">
      {shown.map((mark) => (
        <g key={mark.phi_deg}>
          <line class="guide" x1={left - 4} x2={right} y1={yOf(frame, mark.phi_deg)} y2={yOf(frame, mark.phi_deg)} />
          <text x={left - 8} y={yOf(frame, mark.phi_deg)} text-anchor="end">
            {mark.name}
          </text>
          <text class="small" x={left - 8} y={yOf(frame, mark.phi_deg) + 11} text-anchor="end">
            {fixed(mark.phi_deg, 0)}°
          </text>
        </g>
      ))}
      {ticks(first, last, frame.plotWidth > 500 ? 8 : 4).map((theta) => (
        <g key={theta}>
          <line x1={xOf(frame, theta)} x2={xOf(frame, theta)} y1={bottom} y2={bottom + 4} />
          <text x={xOf(frame, theta)} y={bottom + 17} text-anchor="middle">
            {fixed(theta, 0)}°
          </text>
        </g>
      ))}
      <text x={(left + right) / 2} y={bottom + 34} text-anchor="middle">
        {frame.plotWidth > 500 ? "θ from the contact centre, rolling direction to the right" : "θ, rolling to the right"}
      </text>
    </g>
  );
}

/** Room that a label needs, CSS pixels. */
const LABEL_WIDTH = 22;

function PointMarks({ marks, frame }: { marks: PlaceMark[]; frame: Frame }) {
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
