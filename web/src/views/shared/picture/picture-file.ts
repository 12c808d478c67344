/** Drawings of the page as files. */

/** Pixels of a PNG for one of the page: sharp in print. */
const PNG_SCALE = 3;

/** A drawing as the text of a file. */
export function svgText(sheet: SVGSVGElement): string {
  return new XMLSerializer().serializeToString(sheet);
}

/** A drawing as an image of three pixels for one. */
export async function pngOf(sheet: SVGSVGElement): Promise<Blob> {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svgText(sheet))}`;
  await image.decode();
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [PNG_SCALE * image.width, PNG_SCALE * image.height];
  canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => (blob === null ? reject(new Error("The browser can't write a PNG.")) : resolve(blob)), "image/png");
  });
}

/** Hands a file to the reader. */
export function save(content: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  // The browser takes the file over at the click; its address may go in the next turn.
  window.setTimeout(() => URL.revokeObjectURL(link.href));
}
