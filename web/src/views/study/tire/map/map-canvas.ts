import type { Frame } from "../../../../lib/chart/frame.ts";
import type { Raster } from "../../../../lib/tire/map/field-raster.ts";

/** Paints a raster into the frame, even between its pixels. */
export function paintRaster(canvas: HTMLCanvasElement, raster: Raster, frame: Frame): void {
  const density = window.devicePixelRatio || 1;
  canvas.width = Math.round(frame.width * density);
  canvas.height = Math.round(frame.height * density);
  const context = canvas.getContext("2d");
  const picture = new OffscreenCanvas(raster.width, raster.height);
  const own = picture.getContext("2d");
  if (context === null || own === null) return;
  own.putImageData(new ImageData(raster.pixels, raster.width, raster.height), 0, 0);
  context.imageSmoothingQuality = "high";
  // The outermost pixels' middles are the edges of the map.
  const [sourceWidth, sourceHeight] = [raster.width - 1, raster.height - 1];
  const at = [frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top].map((value) => value * density) as [number, number, number, number];
  context.drawImage(picture, 0.5, 0.5, sourceWidth, sourceHeight, ...at);
}
