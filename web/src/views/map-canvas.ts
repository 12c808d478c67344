import { css } from "../lib/colour.ts";
import { indexOf, shareOf, type Field } from "../lib/map.ts";
import { cellBox, type Frame } from "./map-frame.ts";

const HATCH_SPACING = 7;
const NO_VALUE = "rgb(128 128 128)";

/** Paints the field: a colour per cell, hatching over the cells whose status isn't ok. */
export function paintField(canvas: HTMLCanvasElement, field: Field, frame: Frame): void {
  const density = window.devicePixelRatio || 1;
  canvas.width = Math.round(frame.width * density);
  canvas.height = Math.round(frame.height * density);
  const context = canvas.getContext("2d");
  if (context === null) return;
  context.scale(density, density);
  const marked = new Path2D();
  field.phi_deg.forEach((_, row) =>
    field.theta_deg.forEach((_, column) => {
      const cell = { row, column };
      const index = indexOf(field, cell);
      const value = field.values[index] ?? null;
      const box = cellBox(frame, cell);
      context.fillStyle = value === null ? NO_VALUE : css(field.scale.colour(shareOf(field.scale, value)));
      // Half a pixel more on two sides, or seams show between cells.
      context.fillRect(box.x, box.y, box.width + 0.5, box.height + 0.5);
      if (field.status[index] !== "ok") marked.rect(box.x, box.y, box.width, box.height);
    }),
  );
  hatch(context, marked, frame);
}

function hatch(context: CanvasRenderingContext2D, area: Path2D, frame: Frame): void {
  context.save();
  context.clip(area);
  for (const [colour, shift] of [["rgb(0 0 0 / 55%)", 0], ["rgb(255 255 255 / 55%)", 1]] as const) {
    context.strokeStyle = colour;
    context.lineWidth = 1;
    context.beginPath();
    for (let start = -frame.height + shift; start < frame.width; start += HATCH_SPACING) {
      context.moveTo(start, frame.height);
      context.lineTo(start + frame.height, 0);
    }
    context.stroke();
  }
  context.restore();
}
