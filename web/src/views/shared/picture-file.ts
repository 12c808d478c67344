/** A drawing of the page as a file: its computed style written into it, so that it looks the same elsewhere. */

/** What style gives a shape or a text; as attributes, since the page's policy allows no inline style. */
const STYLES = [
  "fill",
  "stroke",
  "stroke-width",
  "stroke-dasharray",
  "opacity",
  "font-size",
  "font-weight",
  "font-family",
  "text-anchor",
  "paint-order",
  "background-color",
] as const;
/** Pixels of a PNG for one of the page: sharp in print. */
const PNG_SCALE = 3;

/** The drawing by itself, as text; over what a canvas below it shows, if there is one. */
export function svgText(svg: SVGSVGElement, below: HTMLCanvasElement | null = null): string {
  const copy = svg.cloneNode(true) as SVGSVGElement;
  const [from, to] = [
    [svg, ...svg.querySelectorAll("*")],
    [copy, ...copy.querySelectorAll("*")],
  ];
  from.forEach((element, k) => writeStyle(element, to[k]));
  const { width, height } = svg.getBoundingClientRect();
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("width", String(Math.round(width)));
  copy.setAttribute("height", String(Math.round(height)));
  if (below !== null) copy.prepend(imageOf(below, copy, width, height));
  copy.prepend(sheetOf(svg, copy));
  return new XMLSerializer().serializeToString(copy);
}

function writeStyle(from: Element, to: Element | undefined): void {
  const style = getComputedStyle(from);
  for (const name of STYLES) {
    const value = style.getPropertyValue(name);
    if (value !== "" && name !== "background-color") to?.setAttribute(name, value);
  }
  to?.removeAttribute("class");
}

/** The sheet of the page behind it: dark drawings have light lines. */
function sheetOf(svg: SVGSVGElement, copy: SVGSVGElement): SVGRectElement {
  const { x, y, width, height } = svg.viewBox.baseVal.width > 0 ? svg.viewBox.baseVal : { x: 0, y: 0, ...sizeOf(svg) };
  const sheet = copy.ownerDocument.createElementNS("http://www.w3.org/2000/svg", "rect");
  const colour = getComputedStyle(svg.closest(".panel") ?? document.body).backgroundColor;
  for (const [name, value] of Object.entries({ x, y, width, height, fill: colour })) sheet.setAttribute(name, String(value));
  return sheet;
}

function sizeOf(svg: SVGSVGElement): { width: number; height: number } {
  const { width, height } = svg.getBoundingClientRect();
  return { width, height };
}

/** A canvas as an image inside the drawing, as large as that. */
function imageOf(canvas: HTMLCanvasElement, copy: SVGSVGElement, width: number, height: number): SVGImageElement {
  const image = copy.ownerDocument.createElementNS("http://www.w3.org/2000/svg", "image");
  for (const [name, value] of Object.entries({ href: canvas.toDataURL("image/png"), width, height })) image.setAttribute(name, String(value));
  return image;
}

/** The drawing as an image of three pixels for one. */
export async function pngOf(svg: SVGSVGElement, below: HTMLCanvasElement | null = null): Promise<Blob> {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svgText(svg, below))}`;
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
