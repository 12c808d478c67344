import { css } from "../../../lib/colour.ts";
import { indexOf, shareOf, type Field } from "../../../lib/study/surface-field.ts";
import { cellBox, type Frame } from "./map-frame.ts";

const HATCH_SPACING = 9;
const NO_VALUE = "rgb(128 128 128)";

/** Paints the field: a colour per cell, hatching over the cells whose status isn't ok. */
export function paintField(canvas: HTMLCanvasElement, field: Field, frame: Frame): void {
  const density = window.devicePixelRatio || 1;
  canvas.width = Math.round(frame.width * density);
  canvas.height = Math.round(frame.height * density);
  const context = canvas.getContext("2d");
  if (context === null) return;
  const marked = new Path2D();
  field.phi_deg.forEach((_, row) =>
    field.theta_deg.forEach((_, column) => {
      const cell = { row, column };
      const index = indexOf(field, cell);
      const value = field.values[index] ?? null;
      const box = cellBox(frame, cell);
      context.fillStyle = value === null ? NO_VALUE : css(field.scale.colour(shareOf(field.scale, value)));
      // Whole device pixels, or seams show between cells.
      const [left, top] = [Math.round(box.x * density), Math.round(box.y * density)];
      const width = Math.round((box.x + box.width) * density) - left;
      const height = Math.round((box.y + box.height) * density) - top;
      context.fillRect(left, top, width, height);
      if (field.judged && field.status[index] !== "ok") marked.rect(left, top, width, height);
    }),
  );
  hatch(context, marked, density);
}

/** Thin lines, dark beside light, that show on every colour and hide little of it. */
function hatch(context: CanvasRenderingContext2D, area: Path2D, density: number): void {
  const { width, height } = context.canvas;
  context.save();
  context.clip(area);
  context.lineWidth = density;
  for (const [colour, shift] of [["rgb(0 0 0 / 32%)", 0], ["rgb(255 255 255 / 32%)", 1.4]] as const) {
    context.strokeStyle = colour;
    context.beginPath();
    for (let start = -height + shift * density; start < width; start += HATCH_SPACING * density) {
      context.moveTo(start, height);
      context.lineTo(start + height, 0);
    }
    context.stroke();
  }
  context.restore();
}
