/** The picture as it stands, on the page's own ground; null when the browser makes none. */
export async function pictureOf(canvas: HTMLCanvasElement | null): Promise<Blob | null> {
  if (canvas === null) return null;
  const copy = new OffscreenCanvas(canvas.width, canvas.height);
  const context = copy.getContext("2d");
  if (context === null) return null;
  context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--sheet");
  context.fillRect(0, 0, copy.width, copy.height);
  context.drawImage(canvas, 0, 0);
  return copy.convertToBlob({ type: "image/png" });
}
